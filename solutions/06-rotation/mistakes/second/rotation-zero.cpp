    const float theta = glm::radians(degrees), s = std::sin(theta), c = std::cos(theta);
    const glm::vec3 n = glm::normalize(axis);
    glm::mat3 R = glm::mat3(0.0f);
    for (glm::vec3 column : {R[0], R[1], R[2]})
        column += c * glm::vec3(1, 1, 1) + (1 - c) * n + s * n;
    return R;
