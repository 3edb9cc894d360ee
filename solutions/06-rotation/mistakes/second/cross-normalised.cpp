    const float length = std::sqrt(u.x * u.x + u.y * u.y + u.z * u.z);
    glm::mat3 M(0.0f);
    M[1][0] = -u.z;
    M[2][0] = u.y;
    M[0][1] = u.z;
    M[2][1] = -u.x;
    M[0][2] = -u.y;
    M[1][2] = u.x;
    return M / length;
