    glm::vec3 arm = eye - target;
    arm = rotation(degrees, up) * arm;
