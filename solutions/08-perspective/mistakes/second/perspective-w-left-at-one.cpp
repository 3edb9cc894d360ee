    const float n = near, f = far;
    const float top = std::tan(glm::radians(fovy) / 2.0f);
    glm::mat4 P(1.0f);
    P[0] /= aspect * top;
    P[1] /= top;
    P[2] = glm::vec4(0.0f, 0.0f, (f + n) / (n - f), -1.0f);
    P[3] += glm::vec4(0.0f, 0.0f, 2.0f * f * n / (n - f), 0.0f);
    proj = P;
