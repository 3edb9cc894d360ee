glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p, 0.0f) + glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    glm::vec3 v(p.x, p.y, p.z);
    if (p.w != 0.0f)
        v *= 1.0f / p.w;
    return v;
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    const float x = direction.x, y = direction.y, z = direction.z;
    const float length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length, 0.0f};
}

bool isAtInfinity(const glm::vec4 p) {
    return !p.w;
}
