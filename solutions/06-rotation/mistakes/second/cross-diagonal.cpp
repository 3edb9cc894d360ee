    glm::mat3 M(1.0f);
    for (int i = 0; i < 3; ++i)
        M[i] *= u;
    return M;
