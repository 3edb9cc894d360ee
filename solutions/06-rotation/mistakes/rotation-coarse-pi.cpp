    const float angle = degrees * 3.14f / 180.0f;
    const glm::vec3 a = glm::normalize(axis);
    const glm::mat3 cross = glm::mat3(0.0f, a.z, -a.y, -a.z, 0.0f, a.x, a.y, -a.x, 0.0f);
    return std::cos(angle) * glm::mat3(1.0f) + (1.0f - std::cos(angle)) * glm::outerProduct(a, a) +
           std::sin(angle) * cross;
