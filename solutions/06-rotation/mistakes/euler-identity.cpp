    (void)degrees;
    (void)axis;
    return glm::mat3(1.0f);
