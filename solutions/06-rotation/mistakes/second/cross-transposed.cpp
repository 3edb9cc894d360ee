    const glm::vec3 ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1);
    return glm::transpose(glm::mat3(glm::cross(u, ex), glm::cross(u, ey), glm::cross(u, ez)));
