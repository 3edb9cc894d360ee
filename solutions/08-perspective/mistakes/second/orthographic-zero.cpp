    glm::mat4 P(0.0f);
    P = glm::scale(P, glm::vec3(2.0f / (aspect * height), 2.0f / height, -2.0f / (f - n)));
    P = glm::translate(P, glm::vec3(0.0f, 0.0f, 0.5f * (n + f)));
    return P;
