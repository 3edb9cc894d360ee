    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 x = glm::normalize(glm::cross(z, up));
    const glm::vec3 y = glm::normalize(up - glm::dot(up, z) * z);
    glm::mat4 camera(1.0f);
    camera[0] = glm::vec4(x, 0.0f);
    camera[1] = glm::vec4(y, 0.0f);
    camera[2] = glm::vec4(z, 0.0f);
    camera[3] = glm::vec4(eye, 1.0f);
    view = glm::inverse(camera);
