    float degrees = 0.0f;
    for (int k = 0; k < i; ++k)
        degrees += 360.0f / float(n);
    glm::vec2 place(0.0f, 1.0f);
    place.x = std::sin(-degrees);
    place.y = std::cos(-degrees);
    return place;
