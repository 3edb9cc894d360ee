    const float top = height / 2.0f;
    const float right = top / aspect;
    return glm::ortho(-right, right, -top, top, n, f);
