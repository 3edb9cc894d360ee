    const glm::vec3 n = glm::normalize(axis);
    const float t = glm::radians(degrees);
    const auto turned = [&](const glm::vec3 v) {
        const glm::vec3 p = n * glm::dot(v, n);
        return p + (v - p) * std::cos(t) + glm::cross(v, n) * std::sin(t);
    };
    return glm::mat3(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}));
