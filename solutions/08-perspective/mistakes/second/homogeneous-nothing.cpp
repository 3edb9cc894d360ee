glm::vec4 homogenise(const glm::vec3 p) {
    glm::vec4 q(0.0f);
    for (int i = 0; i < 3; ++i) {
        q[i] = p[i];
    }
    return q;
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    const float x = p.x, y = p.y, z = p.z;
    return {x, y, z};
}

glm::vec4 pointAtInfinity(const glm::vec3) {
    return glm::vec4();
}

bool isAtInfinity(const glm::vec4) {
    return false;
}
