glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p, 1.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    return isAtInfinity(p) ? glm::vec3(p) : glm::vec3(p) / p.w;
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(glm::normalize(direction), 0.0f);
}

bool isAtInfinity(const glm::vec4 p) {
    return p.w == 0.0f;
}
