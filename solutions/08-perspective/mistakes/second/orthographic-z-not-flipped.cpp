    const float middle = 0.5f * (n + f);
    const float halfDepth = 0.5f * (f - n);
    const float halfHeight = 0.5f * height;
    glm::mat4 P = glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / (halfHeight * aspect),
                                                        1.0f / halfHeight, 1.0f / halfDepth));
    P = P * glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -middle));
    return P;
