    (void)degrees;
    (void)axis;
    return glm::mat3(0.0f);
