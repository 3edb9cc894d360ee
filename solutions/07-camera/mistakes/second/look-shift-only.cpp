    view = glm::translate(glm::mat4(1.0f), glm::vec3(-eye.x, -eye.y, -eye.z));
