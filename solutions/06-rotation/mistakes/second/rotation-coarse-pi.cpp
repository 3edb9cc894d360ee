    const double pi = 3.14;
    const double c = std::cos(degrees * pi / 180.0);
    const double s = std::sin(degrees * pi / 180.0);
    const glm::dvec3 n = glm::normalize(glm::dvec3(axis));
    glm::dmat3 R;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        R[i][i] = c + (1 - c) * n[i] * n[i];
        R[i][j] = (1 - c) * n[i] * n[j] + s * n[k];
        R[i][k] = (1 - c) * n[i] * n[k] - s * n[j];
    }
    return glm::mat3(R);
