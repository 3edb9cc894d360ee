    const float x = u[0], y = u[1], z = u[2];
    const glm::vec3 row1(0, -z, -y);
    const glm::vec3 row2(z, 0, -x);
    const glm::vec3 row3(y, x, 0);
    return glm::transpose(glm::mat3(row1, row2, row3));
