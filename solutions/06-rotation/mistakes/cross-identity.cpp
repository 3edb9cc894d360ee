    (void)u;
    return glm::mat3(1.0f);
