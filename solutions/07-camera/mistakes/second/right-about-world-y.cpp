    const float phi = degrees * 3.14159265f / 180.0f;
    const float dx = eye.x - target.x;
    const float dz = eye.z - target.z;
    eye.x = target.x + std::cos(phi) * dx + std::sin(phi) * dz;
    eye.z = target.z - std::sin(phi) * dx + std::cos(phi) * dz;
