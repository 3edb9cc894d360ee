    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 y = glm::normalize(up - glm::dot(z, up) * z);
    const glm::vec3 x = glm::cross(y, z);
    view = glm::mat4(glm::mat3(x, y, z));
    view[3] = glm::vec4(eye, 1.0f);
