#include <math.h>

#include "projection.h"

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    float sx = 2.0f / (height * aspect);
    float sy = 2.0f / height;
    float sz = -2.0f / (f - n);
    float c = -0.5f * (n + f);              // z of the center
    return glm::mat4(sx, 0.0f, 0.0f, 0.0f,  // first column
                     0.0f, sy, 0.0f, 0.0f,  // second column
                     0.0f, 0.0f, sz, 0.0f,  // third column
                     0.0f, 0.0f, -sz * c, 1.0f);
}

glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p, 1.0f);
}

bool isAtInfinity(const glm::vec4 p) {
    return fabsf(p[3]) < 1e-6f;
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    if (isAtInfinity(p))
        return glm::vec3(p[0], p[1], p[2]);
    return glm::vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(direction, 0.0f);
}
