// Projections and homogeneous coordinates, chapter 8. You hand this file in.
// The third task of this chapter, `perspective`, is in your Camera.cpp of 07-camera.
#include "projection.h"

#include <cg/Todo.h>

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    // BEGIN TODO(orthographic)
    glm::mat4 P(1.0f);
    P[0][0] = 2.0f / (aspect * height);
    P[1][1] = 2.0f / height;
    P[2][2] = -2.0f / (f - n);  // camera z points back, depth points forward
    P[3][2] = -(f + n) / (f - n);
    return P;
    // END TODO(orthographic)
}

// BEGIN TODO(homogeneous)
glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p, 1.0f);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    return isAtInfinity(p) ? glm::vec3(p) : glm::vec3(p) / p.w;
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(direction, 0.0f);
}

bool isAtInfinity(const glm::vec4 p) {
    return p.w == 0.0f;
}
// END TODO(homogeneous)
