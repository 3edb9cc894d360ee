    const glm::vec3 right = glm::normalize(glm::cross(up, eye - target));
    const glm::mat3 R = rotation(-degrees, right);
    eye = R * eye;
    up = R * up;
