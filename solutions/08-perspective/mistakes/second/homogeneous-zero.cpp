glm::vec4 homogenise(const glm::vec3) {
    const glm::vec4 nothing(0.0f, 0.0f, 0.0f, 0.0f);
    return nothing;
}

glm::vec3 dehomogenise(const glm::vec4) {
    return {0.0f, 0.0f, 0.0f};
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return homogenise(direction);
}

bool isAtInfinity(const glm::vec4) {
    return 0;
}
