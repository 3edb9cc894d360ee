#include "Camera.h"

#include <cmath>
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
    const glm::vec3 back = glm::normalize(eye - target);
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    const glm::mat3 toCamera = glm::transpose(glm::mat3(right, glm::cross(back, right), back));
    view = glm::translate(glm::mat4(toCamera), -eye);

    // The window on the near plane through which the camera looks.
    const float top = near * std::tan(glm::radians(fovy / 2));
    const float side = aspect * top;
    proj = glm::frustum(-side, side, -top, top, near, far);
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
