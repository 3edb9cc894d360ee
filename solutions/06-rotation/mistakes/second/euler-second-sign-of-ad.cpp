    const double theta = glm::radians(double(degrees));
    const glm::dvec3 n = glm::normalize(glm::dvec3(axis));
    const double q0 = std::cos(theta / 2);
    const double q1 = std::sin(theta / 2) * n[0];
    const double q2 = std::sin(theta / 2) * n[1];
    const double q3 = std::sin(theta / 2) * n[2];
    const glm::dvec3 row1(1 - 2 * q2 * q2 - 2 * q3 * q3, 2 * q1 * q2 - 2 * q0 * q3,
                          2 * q1 * q3 + 2 * q0 * q2);
    const glm::dvec3 row2(2 * q1 * q2 - 2 * q0 * q3, 1 - 2 * q1 * q1 - 2 * q3 * q3,
                          2 * q2 * q3 - 2 * q0 * q1);
    const glm::dvec3 row3(2 * q1 * q3 - 2 * q0 * q2, 2 * q2 * q3 + 2 * q0 * q1,
                          1 - 2 * q1 * q1 - 2 * q2 * q2);
    return glm::mat3(glm::transpose(glm::dmat3(row1, row2, row3)));
