    return glm::mat3(u.x, 0.0f, 0.0f, 0.0f, u.y, 0.0f, 0.0f, 0.0f, u.z);
