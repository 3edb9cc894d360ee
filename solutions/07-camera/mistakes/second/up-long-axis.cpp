    const glm::vec3 k = glm::cross(eye - target, up);
    const float c = std::cos(glm::radians(degrees));
    const float s = std::sin(glm::radians(degrees));
    auto turn = [&](const glm::vec3& v) {
        return c * v + s * glm::cross(k, v) + (1.0f - c) * glm::dot(k, v) * k;
    };
    eye = target + turn(eye - target);
    up = turn(up);
