    (void)u;
    return glm::mat3(0.0f);
