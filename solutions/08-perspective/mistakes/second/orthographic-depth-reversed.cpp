    const glm::vec3 size(aspect * height, height, f - n);
    const glm::vec3 centre(0.0f, 0.0f, -(n + f) / 2.0f);
    const glm::mat4 toOrigin = glm::translate(glm::mat4(1.0f), -centre);
    const glm::mat4 toUnit = glm::scale(glm::mat4(1.0f), 2.0f / size);
    return toUnit * toOrigin;
