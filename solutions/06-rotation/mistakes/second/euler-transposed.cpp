    const glm::vec3 n = glm::normalize(axis);
    const float t = glm::radians(degrees / 2);
    const float w = std::cos(t), x = std::sin(t) * n.x, y = std::sin(t) * n.y,
                z = std::sin(t) * n.z;
    const float values[3][3] = {
        {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
        {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
        {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    glm::mat3 R;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            R[i][j] = values[i][j];
    return R;
