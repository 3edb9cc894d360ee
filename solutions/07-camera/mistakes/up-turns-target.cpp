    const glm::vec3 right = glm::normalize(glm::cross(up, eye - target));
    const glm::mat3 R = rotation(-degrees, right);
    eye = R * eye;
    target = R * target;
    up = R * up;
