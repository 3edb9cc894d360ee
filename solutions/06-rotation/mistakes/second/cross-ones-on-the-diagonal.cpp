    const glm::mat3 byRows(1, -u.z, u.y, u.z, 1, -u.x, -u.y, u.x, 1);
    return glm::transpose(byRows);
