// The camera of the model viewer, chapters 7 and 8. You hand this file in.
#include "Camera.h"

#include <cg/Todo.h>

#include <cmath>

#include "rotation.h"  // your own, from 06-rotation

void Camera::rotateRight(const float degrees) {
    // BEGIN TODO(rotate-right)
    eye = target + rotation(degrees, up) * (eye - target);
    // END TODO(rotate-right)
}

void Camera::rotateUp(const float degrees) {
    // BEGIN TODO(rotate-up)
    // up x (eye - target) points to the camera's right; turning clockwise about it lifts the eye.
    const glm::vec3 right = glm::normalize(glm::cross(up, eye - target));
    const glm::mat3 R = rotation(-degrees, right);
    eye = target + R * (eye - target);
    up = R * up;
    // END TODO(rotate-up)
}

void Camera::computeMatrices(void) {
    // BEGIN TODO(look-at)
    const glm::vec3 z = glm::normalize(eye - target);              // eq. (7.29), the camera's back
    const glm::vec3 y = glm::normalize(up - glm::dot(z, up) * z);  // eqs. (7.30), (7.31)
    const glm::vec3 x = glm::cross(y, z);                          // eq. (7.32)
    const glm::mat3 inverse = glm::transpose(glm::mat3(x, y, z));  // eq. (7.35)
    view = glm::mat4(inverse);
    view[3] = glm::vec4(-(inverse * eye), 1.0f);  // eq. (7.36)
    // END TODO(look-at)

    // BEGIN TODO(perspective)
    const float t = std::tan(0.5f * glm::radians(fovy));
    proj = glm::mat4(0.0f);
    proj[0][0] = 1.0f / (aspect * t);
    proj[1][1] = 1.0f / t;
    proj[2][2] = -(far + near) / (far - near);
    proj[2][3] = -1.0f;
    proj[3][2] = -2.0f * far * near / (far - near);
    // END TODO(perspective)
}

void Camera::reset(void) {
    eye = eye_default;
    target = target_default;
    up = up_default;
    fovy = fovy_default;
    aspect = aspect_default;
    near = near_default;
    far = far_default;
}
