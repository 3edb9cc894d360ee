    const float a = glm::radians(degrees);
    const float d = glm::distance(eye, target);
    const glm::vec3 back = (eye - target) / d;
    const glm::vec3 top = glm::normalize(up);
    eye = target + d * (std::cos(a) * back - std::sin(a) * top);
    up = std::cos(a) * top + std::sin(a) * back;
