    (void)height;
    (void)aspect;
    (void)n;
    (void)f;
    return glm::mat4(0.0f);
