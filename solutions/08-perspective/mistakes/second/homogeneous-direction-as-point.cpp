glm::vec4 homogenise(const glm::vec3 p) {
    const float w = 1.0f;
    return glm::vec4(p.x, p.y, p.z, w);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    float divisor = p.w;
    if (isAtInfinity(p))
        divisor = 1.0f;
    return glm::vec3(p / divisor);
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return homogenise(direction);
}

bool isAtInfinity(const glm::vec4 p) {
    return 0.0f == p[3];
}
