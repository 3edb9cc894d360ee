    const glm::mat4 square = glm::perspective(glm::radians(fovy), 1.0f, near, far);
    const glm::mat4 stretch = glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 1.0f / aspect, 1.0f));
    proj = stretch * square;
