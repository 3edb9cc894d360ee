    glm::mat3 M(0.0f);
    for (int j = 0; j < 3; ++j) {
        glm::vec3 column = M[j];
        glm::vec3 e(0.0f);
        e[j] = 1.0f;
        column = glm::cross(u, e);
    }
    return M;
