    const glm::vec3 n = glm::normalize(u);
    return glm::mat3(0.0f, n.z, -n.y, -n.z, 0.0f, n.x, n.y, -n.x, 0.0f);
