    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 y = glm::normalize(up - glm::dot(z, up) * z);
    const glm::vec3 x = glm::cross(z, y);
    const glm::mat3 inverse = glm::transpose(glm::mat3(x, y, z));
    view = glm::mat4(inverse);
    view[3] = glm::vec4(-(inverse * eye), 1.0f);
