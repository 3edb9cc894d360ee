    glm::vec3 arm = eye - target;
    const glm::vec3 sideways = glm::normalize(glm::cross(arm, up));
    const glm::quat q = glm::angleAxis(glm::radians(degrees), sideways);
    arm = q * arm;
    up = q * up;
    eye = target + arm;
