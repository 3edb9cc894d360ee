    const glm::vec3 behind = eye + (eye - target);
    view = glm::lookAt(eye, behind, up);
