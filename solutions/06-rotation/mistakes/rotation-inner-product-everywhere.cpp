    const float angle = glm::radians(degrees);
    const glm::vec3 a = glm::normalize(axis);
    const glm::mat3 cross(0.0f, a.z, -a.y, -a.z, 0.0f, a.x, a.y, -a.x, 0.0f);
    return std::cos(angle) * glm::mat3(1.0f) + (1.0f - std::cos(angle)) * glm::dot(a, a) +
           std::sin(angle) * cross;
