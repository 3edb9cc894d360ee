    const float angle = glm::radians(180.0f * float(i) / float(n));
    return glm::vec2(-std::sin(angle), std::cos(angle));
