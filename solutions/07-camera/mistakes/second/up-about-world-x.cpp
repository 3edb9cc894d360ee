    const float c = std::cos(glm::radians(degrees));
    const float s = std::sin(glm::radians(degrees));
    const float y = eye.y - target.y;
    const float z = eye.z - target.z;
    eye.y = target.y + c * y + s * z;
    eye.z = target.z - s * y + c * z;
    up = glm::vec3(up.x, c * up.y + s * up.z, c * up.z - s * up.y);
