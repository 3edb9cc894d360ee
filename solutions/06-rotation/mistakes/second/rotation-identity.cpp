    const glm::vec3 n = axis / glm::length(axis);
    const double phi = degrees * 3.14159265358979 / 180;
    const auto turn = [&](glm::vec3 v) {
        const glm::vec3 along = n * glm::dot(n, v);
        v = along + float(cos(phi)) * (v - along) + float(sin(phi)) * glm::cross(n, v);
    };
    glm::mat3 R(1.0f);
    turn(R[0]);
    turn(R[1]);
    turn(R[2]);
    return R;
