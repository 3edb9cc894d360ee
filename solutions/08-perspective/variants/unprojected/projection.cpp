#include "projection.h"

// The camera's z at depth -1 and at +1, and the line between: depth = slope * z + shift.
glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    const float zNear = -n, zFar = -f;
    const float slope = (1.0f - -1.0f) / (zFar - zNear);
    const float shift = 1.0f - slope * zFar;
    const float top = 0.5f * height;
    glm::mat4 P;
    P[0] = {1.0f / (aspect * top), 0.0f, 0.0f, 0.0f};
    P[1] = {0.0f, 1.0f / top, 0.0f, 0.0f};
    P[2] = {0.0f, 0.0f, slope, 0.0f};
    P[3] = {0.0f, 0.0f, shift, 1.0f};
    return P;
}

glm::vec4 homogenise(const glm::vec3 p) {
    return pointAtInfinity(p) + glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    const glm::vec3 xyz(p);
    if (p.w == 0.0f) {
        return xyz;
    } else {
        return xyz / p.w;
    }
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    glm::vec4 q(0.0f);
    q.x = direction.x, q.y = direction.y, q.z = direction.z;
    return q;
}

bool isAtInfinity(const glm::vec4 p) {
    return !(p.w > 0.0f) && !(p.w < 0.0f);
}
