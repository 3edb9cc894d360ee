    const float right = aspect, top = 1.0f, depth = 10.0f;
    proj = glm::ortho(-right, right, -top, top, -depth, depth);
