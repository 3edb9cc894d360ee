    const glm::mat4 worldToCamera = glm::lookAt(eye, target, up);
    view = glm::inverse(worldToCamera);
