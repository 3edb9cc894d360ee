#include "Camera.h"

#include <glm/gtc/matrix_transform.hpp>

static glm::mat3 turnAbout(const glm::vec3 axis, const float degrees) {
    return glm::mat3(glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis));
}

void Camera::rotateRight(const float degrees) {
    eye = turnAbout(up, degrees) * (eye - target) + target;
}

void Camera::rotateUp(const float degrees) {
    const glm::mat3 turn = turnAbout(glm::cross(eye - target, up), degrees);
    eye = turn * (eye - target) + target;
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
