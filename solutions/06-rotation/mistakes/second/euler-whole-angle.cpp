    const float t = glm::radians(degrees);
    const glm::vec3 w = axis * (std::sin(t) / glm::length(axis));
    const float q = std::cos(t);
    glm::mat3 R = 2.0f * glm::outerProduct(w, w);
    for (int j = 0; j < 3; ++j) {
        const int k = (j + 1) % 3, l = (j + 2) % 3;
        R[j][j] += q * q - glm::dot(w, w);
        R[j][k] += 2 * q * w[l];
        R[j][l] -= 2 * q * w[k];
    }
    return R;
