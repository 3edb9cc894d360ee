#include "Camera.h"

#include <cmath>

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
    computeView();
    computeProjection();
}

void Camera::computeView(void) {
    const glm::vec3 d = eye - target;
    const glm::vec3 z = d / std::sqrt(glm::dot(d, d));
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    const glm::vec3 rows[] = {x, glm::cross(z, x), z};
    view = glm::mat4(1.0f);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            view[j][i] = rows[i][j];
        view[3][i] = -glm::dot(rows[i], eye);
    }
}

// Depth is (a z + b) / -z; it is -1 at z = -near and 1 at z = -far:
// -near a + b = -near, -far a + b = far.
void Camera::computeProjection(void) {
    const glm::mat2 M(-near, -far, 1.0f, 1.0f);
    const glm::vec2 ab = glm::inverse(M) * glm::vec2(-near, far);
    proj = glm::mat4(glm::vec4(1.0f / (aspect * slope()), 0.0f, 0.0f, 0.0f),
                     glm::vec4(0.0f, 1.0f / slope(), 0.0f, 0.0f),
                     glm::vec4(0.0f, 0.0f, ab.x, -1.0f), glm::vec4(0.0f, 0.0f, ab.y, 0.0f));
}

float Camera::slope(void) const {
    const float half = glm::radians(0.5f * fovy);
    return std::sin(half) / std::cos(half);
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
