    const float top = near * std::tan(fovy * 3.14159265f / 180.0f);
    const float right = aspect * top;
    proj = glm::frustum(-right, right, -top, top, near, far);
