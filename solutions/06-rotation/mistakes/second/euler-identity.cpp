    const float t = glm::radians(degrees);
    const glm::vec3 n = glm::normalize(axis);
    const float s = std::sin(1 / 2 * t);
    const float q0 = std::cos(1 / 2 * t), q1 = s * n.x, q2 = s * n.y, q3 = s * n.z;
    return glm::mat3(1 - 2 * (q2 * q2 + q3 * q3), 2 * (q1 * q2 + q0 * q3), 2 * (q1 * q3 - q0 * q2),
                     2 * (q1 * q2 - q0 * q3), 1 - 2 * (q1 * q1 + q3 * q3), 2 * (q2 * q3 + q0 * q1),
                     2 * (q1 * q3 + q0 * q2), 2 * (q2 * q3 - q0 * q1), 1 - 2 * (q1 * q1 + q2 * q2));
