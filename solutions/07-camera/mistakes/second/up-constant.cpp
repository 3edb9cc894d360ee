    const glm::mat3 frame(rotation(0.0f * degrees, glm::vec3(0.0f, 0.0f, 1.0f)));
    eye = 5.0f * frame[0];
    up = frame[1];
