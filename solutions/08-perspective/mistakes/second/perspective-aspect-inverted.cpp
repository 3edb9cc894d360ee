    const float heightByWidth = 1.0f / aspect;
    proj = glm::perspective(glm::radians(fovy), heightByWidth, near, far);
