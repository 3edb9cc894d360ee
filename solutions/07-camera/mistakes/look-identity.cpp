    view = glm::mat4(1.0f);
