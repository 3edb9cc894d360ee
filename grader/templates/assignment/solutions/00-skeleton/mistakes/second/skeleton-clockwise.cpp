    const float angle = 1.5707963f - 6.2831853f * float(i) / float(n);
    const float x = std::cos(angle), y = std::sin(angle);
    return {x, y};
