// Projections and homogeneous coordinates, chapter 8. You hand this file in.
// The third task of this chapter, `perspective`, is in your Camera.cpp of 07-camera.
#include "projection.h"

#include <cg/Todo.h>

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    // BEGIN TODO(orthographic)
    // The centre of the box is at z = -(n + f) / 2.
    glm::mat4 T(1.0f);
    T[3] = glm::vec4(0.0f, 0.0f, 0.5f * (n + f), 1.0f);
    glm::mat4 S(1.0f);
    S[0] *= 1.0f / (0.5f * aspect * height);
    S[1] *= 1.0f / (0.5f * height);
    S[2] *= -1.0f / (0.5f * (f - n));
    return S * T;
    // END TODO(orthographic)
}

// BEGIN TODO(homogeneous)
bool isAtInfinity(const glm::vec4 p) {
    const float tiny = 1e-7f;
    return p.w > -tiny && p.w < tiny;
}

glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p.x, p.y, p.z, 1.0f);
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(direction.x, direction.y, direction.z, 0.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    glm::vec3 q(p.x, p.y, p.z);
    if (!isAtInfinity(p)) {
        q.x /= p.w;
        q.y /= p.w;
        q.z /= p.w;
    }
    return q;
}
// END TODO(homogeneous)
