glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p.x, p.y, p.z, 1);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    glm::vec4 q = p;
    q /= q.w;
    return {q.x, q.y, q.z};
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    glm::vec4 d(0.0f);
    d += glm::vec4(direction.x, direction.y, direction.z, 0);
    return d;
}

bool isAtInfinity(const glm::vec4 p) {
    return std::abs(p.w) < 1e-9f;
}
