    const glm::vec3 axis = glm::cross(eye - target, up);
    const glm::mat4 lift = glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis);
    eye = glm::vec3(lift * glm::vec4(eye, 1.0f));
    up = glm::vec3(lift * glm::vec4(up, 0.0f));
