    proj = glm::mat4(0.0f);
