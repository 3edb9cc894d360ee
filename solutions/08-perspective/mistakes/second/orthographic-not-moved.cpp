    const glm::vec3 halves = 0.5f * glm::vec3(aspect * height, height, n - f);
    return glm::scale(glm::mat4(1.0f), 1.0f / halves);
