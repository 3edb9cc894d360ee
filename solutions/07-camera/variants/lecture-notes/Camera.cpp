#include "Camera.h"

#include <math.h>

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    const float theta = degrees * float(M_PI) / 180.0f;
    const glm::vec3 a = axis / sqrtf(glm::dot(axis, axis));
    // R = cos(theta) I + (1 - cos(theta)) a a^T + sin(theta) [a x]
    const glm::mat3 I(1.0f);
    const glm::mat3 aaT(a.x * a, a.y * a, a.z * a);
    const glm::mat3 ax(0.0f, a.z, -a.y,  // first column
                       -a.z, 0.0f, a.x,  // second column
                       a.y, -a.x, 0.0f);
    return cosf(theta) * I + (1.0f - cosf(theta)) * aaT + sinf(theta) * ax;
}

void Camera::rotateRight(const float degrees) {
    glm::mat3 R = rotation(degrees, up);
    eye = R * (eye - target) + target;
}
void Camera::rotateUp(const float degrees) {
    glm::vec3 axis = glm::cross(eye - target, up);
    glm::mat3 R = rotation(degrees, axis);
    eye = R * (eye - target) + target;
    up = R * up;
}

void Camera::computeMatrices() {
    // view: the camera matrix, inverted
    glm::vec3 z = glm::normalize(eye - target);
    up = up - glm::dot(z, up) * z;
    up = glm::normalize(up);
    glm::vec3 x = glm::cross(up, z);
    // row by row
    for (int j = 0; j < 3; j++) {
        view[j][0] = x[j];
        view[j][1] = up[j];
        view[j][2] = z[j];
        view[j][3] = 0.0f;
    }
    view[3][0] = -glm::dot(x, eye);
    view[3][1] = -glm::dot(up, eye);
    view[3][2] = -glm::dot(z, eye);
    view[3][3] = 1.0f;

    // proj
    // (comes with chapter 8)
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
