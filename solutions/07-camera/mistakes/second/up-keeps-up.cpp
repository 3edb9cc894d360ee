    const float r = glm::length(eye - target);
    const glm::vec3 z = (eye - target) / r;
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    const glm::vec3 y = glm::cross(z, x);
    const float t = glm::radians(degrees);
    eye = target + r * std::cos(t) * z + r * std::sin(t) * y;
