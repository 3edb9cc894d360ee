#include "projection.h"

#include <glm/gtc/matrix_transform.hpp>

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    // From the box from -1 to 1 back to the camera's, then the other way round.
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -(n + f) / 2.0f});
    const glm::mat4 box =
        glm::scale(moved, {aspect * height / 2.0f, height / 2.0f, (n - f) / 2.0f});
    return glm::inverse(box);
}

namespace {

constexpr float kPoint = 1.0f, kDirection = 0.0f;

}  // namespace

glm::vec4 homogenise(const glm::vec3 p) {
    return glm::vec4(p, kPoint);
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    switch (isAtInfinity(p)) {
        case true:
            return glm::vec3(p);
        default:
            return (1.0f / p.w) * glm::vec3(p);
    }
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    return glm::vec4(direction, kDirection);
}

bool isAtInfinity(const glm::vec4 p) {
    return p.w == kDirection;
}
