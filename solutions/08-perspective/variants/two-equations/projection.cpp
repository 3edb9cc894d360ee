#include "projection.h"

#include <glm/gtc/matrix_transform.hpp>

static float mapped(float value, float from, float to) {
    return (2.0f * value - from - to) / (to - from);
}

// An affine map is known by the images of the origin and the three unit vectors.
glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    const float width = aspect * height;
    const auto image = [&](float x, float y, float z) {
        return glm::vec4(mapped(x, -width / 2, width / 2), mapped(y, -height / 2, height / 2),
                         mapped(z, -n, -f), 1.0f);
    };
    const glm::vec4 origin = image(0, 0, 0);
    return glm::mat4(image(1, 0, 0) - origin, image(0, 1, 0) - origin, image(0, 0, 1) - origin,
                     origin);
}

bool isAtInfinity(const glm::vec4 p) {
    return p == glm::vec4(glm::vec3(p), 0.0f);
}

glm::vec4 homogenise(const glm::vec3 p) {
    return glm::translate(glm::mat4(1.0f), p)[3];
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    glm::vec4 q = p;
    if (!isAtInfinity(q))
        q *= 1.0f / q.w;
    return glm::vec3(q);
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return homogenise(direction) - homogenise(glm::vec3(0.0f));
}
