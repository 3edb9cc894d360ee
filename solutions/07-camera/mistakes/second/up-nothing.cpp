    const glm::vec3 axis = glm::normalize(glm::cross(eye - target, up));
    const auto turned = [&](glm::vec3 v) {
        v = rotation(degrees, axis) * v;
    };
    turned(eye);
    turned(up);
