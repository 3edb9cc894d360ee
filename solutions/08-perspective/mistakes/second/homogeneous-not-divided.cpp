bool isAtInfinity(const glm::vec4 p) {
    if (p[3] == 0.0f)
        return true;
    return false;
}

glm::vec4 homogenise(const glm::vec3 p) {
    return {p.x, p.y, p.z, 1.0f};
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    glm::vec3 point;
    for (int i = 0; i < 3; ++i) {
        point[i] = p[i];
    }
    return point;
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return homogenise(direction) - glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}
