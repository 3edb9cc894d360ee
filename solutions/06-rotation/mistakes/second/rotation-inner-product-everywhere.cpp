    const glm::vec3 n = axis / glm::length(axis);
    const float phi = degrees * std::acos(-1.0f) / 180.0f;
    const float c = std::cos(phi), s = std::sin(phi), square = n.x * n.x + n.y * n.y + n.z * n.z;
    glm::mat3 R(c);
    R += (1 - c) * square;
    R += s * glm::mat3(0, n.z, -n.y, -n.z, 0, n.x, n.y, -n.x, 0);
    return R;
