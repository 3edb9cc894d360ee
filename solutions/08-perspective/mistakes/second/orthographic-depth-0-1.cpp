    const glm::mat4 forward = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, n));
    const glm::mat4 shrink = glm::scale(
        glm::mat4(1.0f), glm::vec3(2.0f / (height * aspect), 2.0f / height, 1.0f / (n - f)));
    return shrink * forward;
