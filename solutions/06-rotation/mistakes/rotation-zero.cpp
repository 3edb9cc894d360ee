    (void)degrees;
    (void)axis;
    glm::mat3 R(0.0f);
    return R;
