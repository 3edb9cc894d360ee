    (void)height;
    (void)aspect;
    (void)n;
    (void)f;
    return glm::mat4(1.0f);
