    proj = glm::perspective(fovy, aspect, near, far);
