    const float right = 0.5f * aspect * height, top = 0.5f * height, middle = 0.5f * (n + f);
    const float half = 0.5f * (f - n);
    return glm::mat4(1.0f / right, 0.0f, 0.0f, 0.0f,             //
                     0.0f, 1.0f / top, 0.0f, 0.0f,               //
                     0.0f, 0.0f, -1.0f / half, -middle / half,   //
                     0.0f, 0.0f, 0.0f, 1.0f);
