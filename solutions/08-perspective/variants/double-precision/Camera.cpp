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
    const glm::dvec3 e(eye), c(target), u(up);
    view = glm::mat4(glm::lookAt(e, c, u));

    const double n = near, f = far;
    const double angle = fovy * std::acos(-1.0) / 180.0;
    // The cotangent of the half is (1 + cos) / sin of the whole.
    const double cot = (1.0 + std::cos(angle)) / std::sin(angle);
    glm::dmat4 P(0.0);
    P[0][0] = cot / aspect;
    P[1][1] = cot;
    P[2][2] = (n + f) / (n - f);
    P[2][3] = -1.0;
    P[3][2] = 2.0 * n * f / (n - f);
    proj = glm::mat4(P);
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
