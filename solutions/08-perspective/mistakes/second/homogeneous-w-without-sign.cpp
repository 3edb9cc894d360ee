glm::vec4 homogenise(const glm::vec3 p) {
    return {p, 1.0f};
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    const float size = std::sqrt(p.w * p.w);
    if (size == 0.0f)
        return {p.x, p.y, p.z};
    return {p.x / size, p.y / size, p.z / size};
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return {direction, 0.0f};
}

bool isAtInfinity(const glm::vec4 p) {
    return p.w * p.w == 0.0f;
}
