#include "Camera.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace {

// The quaternion of a turn by some degrees about an axis of any length.
glm::quat turn(float degrees, glm::vec3 axis) {
    const float half = glm::radians(degrees) / 2;
    axis = glm::normalize(axis) * std::sin(half);
    return glm::quat(std::cos(half), axis.x, axis.y, axis.z);
}

glm::vec3 apply(const glm::quat& q, const glm::vec3& v) {
    const glm::quat image = q * glm::quat(0, v.x, v.y, v.z) * glm::conjugate(q);
    return {image.x, image.y, image.z};
}

}  // namespace

void Camera::rotateRight(const float degrees) {
    eye = target + apply(turn(degrees, up), eye - target);
}

void Camera::rotateUp(const float degrees) {
    const glm::quat q = turn(-degrees, glm::cross(up, eye - target));
    eye = target + apply(q, eye - target);
    up = apply(q, up);
}

void Camera::computeMatrices(void) {
    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    const glm::quat pose = glm::normalize(glm::quat_cast(glm::mat3(x, glm::cross(z, x), z)));
    const glm::quat back = glm::conjugate(pose);
    view = glm::mat4_cast(back);
    view[3] = glm::vec4(back * -eye, 1);
}

void Camera::reset(void) {
    eye = eye_default, target = target_default, up = up_default;
    fovy = fovy_default, aspect = aspect_default;
    near = near_default, far = far_default;
}
