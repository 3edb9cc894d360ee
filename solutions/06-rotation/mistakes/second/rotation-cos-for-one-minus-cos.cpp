    const float pi = std::acos(-1.0f);
    const float c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    const glm::vec3 u = glm::normalize(axis);
    glm::mat3 R;
    R[0] = glm::vec3(c + c * u.x * u.x, c * u.x * u.y + s * u.z, c * u.x * u.z - s * u.y);
    R[1] = glm::vec3(c * u.x * u.y - s * u.z, c + c * u.y * u.y, c * u.y * u.z + s * u.x);
    R[2] = glm::vec3(c * u.x * u.z + s * u.y, c * u.y * u.z - s * u.x, c + c * u.z * u.z);
    return R;
