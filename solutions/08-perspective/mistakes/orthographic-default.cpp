    (void)height;
    (void)n;
    (void)f;
    glm::mat4 P(1.0f);
    P[0][0] = 1.0f / aspect;
    P[1][1] = 1.0f;
    P[2][2] = -0.1f;
    return P;
