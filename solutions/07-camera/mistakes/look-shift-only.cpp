    view = glm::mat4(1.0f);
    view[3] = glm::vec4(-eye, 1.0f);
