    const float angle = glm::radians(degrees);
    const glm::vec3 a = glm::normalize(axis);
    return std::cos(angle) * glm::mat3(1.0f) + (1.0f - std::cos(angle)) * glm::outerProduct(a, a);
