    const float radius = glm::distance(eye_default, target_default);
    static_cast<void>(degrees);
    eye.x = target_default.x + radius;
    eye.y = target_default.y;
    eye.z = target_default.z;
