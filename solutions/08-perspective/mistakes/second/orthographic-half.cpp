    const float width = aspect * height;
    return glm::ortho(-width, width, -height, height, n, f);
