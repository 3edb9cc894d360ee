    (void)i;
    (void)n;
    return glm::vec2(0.0f);
