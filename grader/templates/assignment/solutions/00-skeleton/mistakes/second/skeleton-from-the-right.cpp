    const float step = 6.2831853f / float(n);
    glm::vec2 place(1.0f, 0.0f);
    for (int k = 0; k < i; ++k)
        place = glm::vec2(std::cos(step) * place.x - std::sin(step) * place.y,
                          std::sin(step) * place.x + std::cos(step) * place.y);
    return place;
