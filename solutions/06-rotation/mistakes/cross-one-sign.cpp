    return glm::mat3(0.0f, u.z, u.y, -u.z, 0.0f, u.x, -u.y, -u.x, 0.0f);
