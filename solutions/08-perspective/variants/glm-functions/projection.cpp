#include "projection.h"

#include <glm/gtc/matrix_transform.hpp>

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    const float top = height / 2, right = top * aspect;
    return glm::ortho(-right, right, -top, top, n, f);
}

glm::vec4 homogenise(const glm::vec3 p) {
    return {p, 1};
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    if (isAtInfinity(p))
        return p;
    return p / p.w;
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return {direction, 0};
}

bool isAtInfinity(const glm::vec4 p) {
    return p.w == 0;
}
