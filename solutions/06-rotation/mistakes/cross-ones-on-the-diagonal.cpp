    glm::mat3 M;
    M[0][1] = u.z;
    M[0][2] = -u.y;
    M[1][0] = -u.z;
    M[1][2] = u.x;
    M[2][0] = u.y;
    M[2][1] = -u.x;
    return M;
