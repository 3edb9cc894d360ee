    const float lens = glm::radians(fovy);
    glm::mat4 P = glm::perspective(lens, aspect, near, far);
    P = P * proj;
