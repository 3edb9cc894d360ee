    const float t = glm::radians(degrees);
    const float s = std::sin(t), c = std::cos(t), k = 1 - c;
    const glm::vec3 n = axis / std::sqrt(glm::dot(axis, axis));
    const float x = n.x, y = n.y, z = n.z;
    return glm::mat3(c + k * x * x, k * x * y - s * z, k * x * z + s * y,
                     k * y * x + s * z, c + k * y * y, k * y * z - s * x,
                     k * z * x - s * y, k * z * y + s * x, c + k * z * z);
