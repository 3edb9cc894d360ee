    const float unused = height + n + f;
    (void)unused;
    return glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / aspect, 1.0f, -0.1f));
