    const glm::mat3 R = rotation(-degrees, glm::vec3(1.0f, 0.0f, 0.0f));
    eye = target + R * (eye - target);
    up = R * up;
