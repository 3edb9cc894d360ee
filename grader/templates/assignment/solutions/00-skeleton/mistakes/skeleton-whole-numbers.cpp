    const float angle = i / n * 6.2831853f;
    return glm::vec2(-std::sin(angle), std::cos(angle));
