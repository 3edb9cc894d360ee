#include "Camera.h"

#include <cmath>

Camera::Basis Camera::basis() const {
    Basis b;
    b.back = glm::normalize(eye - target);
    b.right = glm::normalize(glm::cross(up, b.back));
    b.top = glm::cross(b.back, b.right);
    return b;
}

glm::vec3 Camera::Basis::toWorld(const glm::vec3& v) const {
    return v.x * right + v.y * top + v.z * back;
}

glm::vec3 Camera::Basis::toCamera(const glm::vec3& v) const {
    return {glm::dot(v, right), glm::dot(v, top), glm::dot(v, back)};
}

// arm and newUp are seen from the camera before it moves.
void Camera::place(const Basis& basis, const glm::vec3& arm, const glm::vec3& newUp) {
    eye = target + glm::distance(eye, target) * basis.toWorld(arm);
    up = basis.toWorld(newUp);
}

void Camera::rotateRight(const float degrees) {
    const float a = glm::radians(degrees);
    place(basis(), {std::sin(a), 0, std::cos(a)}, {0, 1, 0});
}

void Camera::rotateUp(const float degrees) {
    const float a = glm::radians(degrees);
    place(basis(), {0, std::sin(a), std::cos(a)}, {0, std::cos(a), -std::sin(a)});
}

void Camera::computeMatrices() {
    const Basis b = basis();
    view = glm::mat4(1);
    for (int column = 0; column < 3; ++column) {
        glm::vec3 e(0);
        e[column] = 1;
        view[column] = glm::vec4(b.toCamera(e), 0);
    }
    view[3] = glm::vec4(b.toCamera(-eye), 1);
}

void Camera::reset() {
    eye = eye_default;
    target = target_default;
    up = up_default;
    fovy = fovy_default;
    aspect = aspect_default;
    near = near_default;
    far = far_default;
}
