    const float t = glm::radians(degrees);
    const glm::vec3 n = axis * glm::inversesqrt(glm::dot(axis, axis));
    const float aTa = n.x * n.x + n.y * n.y + n.z * n.z;
    glm::mat3 R;
    for (int j = 0; j < 3; ++j) {
        const glm::vec3 e(j == 0, j == 1, j == 2);
        R[j] = std::cos(t) * e;
        R[j] += (1 - std::cos(t)) * aTa * e;
        R[j] += std::sin(t) * glm::cross(n, e);
    }
    return R;
