    glm::mat3 M(0.0f);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != j)
                M[j][i] = u[3 - i - j];
    return M;
