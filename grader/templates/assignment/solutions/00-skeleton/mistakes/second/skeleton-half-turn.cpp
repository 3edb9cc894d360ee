    const double angle = std::acos(-1.0) * double(i) / double(n);
    return glm::vec2(float(std::cos(angle + std::acos(0.0))), float(std::sin(angle + std::acos(0.0))));
