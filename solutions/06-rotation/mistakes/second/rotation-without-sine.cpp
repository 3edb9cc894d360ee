    const float c = std::cos(glm::radians(degrees));
    const float squared = glm::dot(axis, axis);
    glm::mat3 R;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const float along = axis[i] * axis[j] / squared;
            const float across = (i == j ? 1.0f : 0.0f) - along;
            R[j][i] = along + c * across;
        }
    }
    return R;
