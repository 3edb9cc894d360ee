    const float distance = glm::length(eye - target);
    const glm::vec3 back = (eye - target) / distance;
    const glm::vec3 right = glm::cross(up, back) / glm::length(up);
    const float theta = glm::radians(degrees);
    const float step = distance * std::sin(theta) / std::cos(theta);
    eye = eye + step * right;
