glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p, 0.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    return glm::vec3(p);
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(0.0f * direction, 0.0f);
}

bool isAtInfinity(const glm::vec4 p) {
    return p.w != p.w;
}
