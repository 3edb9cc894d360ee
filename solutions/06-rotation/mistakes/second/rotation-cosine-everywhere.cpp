    const glm::vec3 n = axis / glm::length(axis);
    const float phi = degrees * std::acos(-1.0f) / 180.0f;
    glm::mat3 R(0.0f);
    for (int j = 0; j < 3; ++j) {
        glm::vec3 e(0.0f);
        e[j] = 1.0f;
        R[j] = std::cos(phi) + (1 - std::cos(phi)) * n[j] * n + std::sin(phi) * glm::cross(n, e);
    }
    return R;
