    const float c = std::cos(glm::radians(degrees));
    const float s = std::sin(glm::radians(degrees));
    const glm::vec3 u = up / glm::length(up);
    const glm::vec3 along = glm::dot(u, eye) * u;
    const glm::vec3 across = eye - along;
    eye = along + c * across + s * glm::cross(u, across);
