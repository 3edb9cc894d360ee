    const float half = degrees * 3.14f / 360.0f;
    const glm::vec3 bcd = std::sin(half) * glm::normalize(axis);
    const float a = std::cos(half), b = bcd.x, c = bcd.y, d = bcd.z;
    glm::mat3 R(0.0f);
    R[0] = glm::vec3(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c));
    R[1] = glm::vec3(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b));
    R[2] = glm::vec3(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d);
    return R;
