    const double half = glm::radians(double(fovy)) / 2.0;
    const double cot = std::cos(half) / std::sin(half);
    const double n = near, f = far, depth = f - n;
    const float values[4][4] = {{float(cot / aspect), 0.0f, 0.0f, 0.0f},
                                {0.0f, float(cot), 0.0f, 0.0f},
                                {0.0f, 0.0f, float(-(f + n) / depth), float(-2.0 * f * n / depth)},
                                {0.0f, 0.0f, 0.0f, 0.0f}};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            proj[j][i] = values[i][j];
        }
    }
