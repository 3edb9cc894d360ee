#include "projection.h"

#include <cmath>

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    const double h = height, w = double(aspect) * h, depth = double(n) - double(f);
    const glm::dmat4 P(2.0 / w, 0.0, 0.0, 0.0,      //
                       0.0, 2.0 / h, 0.0, 0.0,      //
                       0.0, 0.0, 2.0 / depth, 0.0,  //
                       0.0, 0.0, (double(n) + double(f)) / depth, 1.0);
    return glm::mat4(P);
}

glm::vec4 homogenise(const glm::vec3 p) {
    glm::vec4 result(1.0f);
    for (int i = 0; i < 3; ++i)
        result[i] = p[i];
    return result;
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    const double w = isAtInfinity(p) ? 1.0 : double(p.w);
    return glm::vec3(float(p.x / w), float(p.y / w), float(p.z / w));
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    glm::vec4 result(0.0f);
    for (int i = 0; i < 3; ++i)
        result[i] = direction[i];
    return result;
}

bool isAtInfinity(const glm::vec4 p) {
    return std::fpclassify(p.w) == FP_ZERO;
}
