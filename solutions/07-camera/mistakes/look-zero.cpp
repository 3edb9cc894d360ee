    view = glm::mat4(0.0f);
