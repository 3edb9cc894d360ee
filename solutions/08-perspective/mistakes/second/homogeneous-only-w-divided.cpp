glm::vec4 homogenise(const glm::vec3 p) {
    glm::vec4 q(1.0f);
    q.x = p.x;
    q.y = p.y;
    q.z = p.z;
    return q;
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    glm::vec4 scaled = p;
    if (!isAtInfinity(p)) {
        scaled.w /= p.w;
    }
    return {scaled.x, scaled.y, scaled.z};
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    glm::vec4 q = homogenise(direction);
    q.w = 0.0f;
    return q;
}

bool isAtInfinity(const glm::vec4 p) {
    return !(p.w < 0.0f || p.w > 0.0f);
}
