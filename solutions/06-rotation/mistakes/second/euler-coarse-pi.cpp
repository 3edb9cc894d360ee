    const float radians = degrees / 180 * 3.14f;
    const float a = std::cos(radians / 2);
    const glm::vec3 w = glm::normalize(axis) * std::sin(radians / 2);
    const auto turned = [a, w](const glm::vec3 v) {
        const glm::vec3 t = 2.0f * glm::cross(w, v);
        return v + a * t + glm::cross(w, t);
    };
    return glm::mat3(turned(glm::vec3(1, 0, 0)), turned(glm::vec3(0, 1, 0)),
                     turned(glm::vec3(0, 0, 1)));
