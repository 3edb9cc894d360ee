    const glm::mat4 P(1.0f);
    const glm::vec3 factors(2.0f / (aspect * height), 2.0f / height, -2.0f / (f - n));
    glm::scale(P, factors);
    glm::translate(P, glm::vec3(0.0f, 0.0f, 0.5f * (n + f)));
    return P;
