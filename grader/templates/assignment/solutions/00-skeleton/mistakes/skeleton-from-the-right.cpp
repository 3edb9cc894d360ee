    const float angle = glm::radians(360.0f * float(i) / float(n));
    return glm::vec2(std::cos(angle), std::sin(angle));
