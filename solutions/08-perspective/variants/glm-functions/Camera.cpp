#include "Camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include "rotation.h"

void Camera::rotateRight(const float degrees) {
    eye = target + rotation(degrees, up) * (eye - target);
}

void Camera::rotateUp(const float degrees) {
    const glm::mat3 turn = rotation(degrees, glm::cross(eye - target, up));
    eye = target + turn * (eye - target);
    up = turn * up;
}

void Camera::computeMatrices(void) {
    view = glm::lookAt(eye, target, up);
    proj = glm::perspective(glm::radians(fovy), aspect, near, far);
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
