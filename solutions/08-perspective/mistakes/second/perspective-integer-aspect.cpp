    const int ratio = static_cast<int>(std::lround(aspect));
    const float half = glm::radians(fovy) / 2.0f;
    const float top = near * std::sin(half) / std::cos(half);
    const float right = static_cast<float>(ratio) * top;
    proj = glm::frustum(-right, right, -top, top, near, far);
