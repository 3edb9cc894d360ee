bool isAtInfinity(const glm::vec4 p) {
    return !(p.w > 0.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    if (isAtInfinity(p))
        return {p.x, p.y, p.z};
    const float inverse = 1.0f / p.w;
    return {inverse * p.x, inverse * p.y, inverse * p.z};
}

glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p[0], p[1], p[2], 1.0f);
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(direction[0], direction[1], direction[2], 0.0f);
}
