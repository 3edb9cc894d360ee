    const glm::vec3 a = glm::cross(up, eye - target);
    const float angle = glm::radians(-degrees);
    const glm::mat3 cross(0.0f, a.z, -a.y, -a.z, 0.0f, a.x, a.y, -a.x, 0.0f);
    const glm::mat3 R = std::cos(angle) * glm::mat3(1.0f) +
                        (1.0f - std::cos(angle)) * glm::outerProduct(a, a) +
                        std::sin(angle) * cross;
    eye = target + R * (eye - target);
    up = R * up;
