    const float side = height / 2.0f;
    const float top = side / aspect;
    const float depth = n - f;
    glm::mat4 P = glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / side, 1.0f / top, 2.0f / depth));
    P[3].z = (n + f) / depth;
    return P;
