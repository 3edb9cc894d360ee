    const double t = glm::radians(static_cast<double>(degrees));
    const float c = static_cast<float>(std::cos(t)), s = static_cast<float>(std::sin(t));
    glm::mat3 R = glm::mat3(1.0f);
    for (int j = 0; j < 3; j++) {
        const glm::vec3 e = R[j];
        const glm::vec3 along = axis * axis[j];
        const glm::vec3 across = e - along;
        R[j] = along + c * across + s * glm::cross(axis, e);
    }
    return R;
