// The camera of the model viewer, chapters 7 and 8. You hand this file in.
#include "Camera.h"

#include <cmath>

void Camera::rotateRight(const float degrees) {
    // BEGIN TODO(rotate-right)
    const float distance = glm::length(eye - target);
    const glm::vec3 back = (eye - target) / distance;
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    const float angle = glm::radians(degrees);
    eye = target + distance * std::cos(angle) * back + distance * std::sin(angle) * right;
    // END TODO(rotate-right)
}

void Camera::rotateUp(const float degrees) {
    // BEGIN TODO(rotate-up)
    const float distance = glm::length(eye - target);
    const glm::vec3 back = (eye - target) / distance;
    const glm::vec3 top = up;
    const float angle = glm::radians(degrees);
    eye = target + distance * (std::cos(angle) * back + std::sin(angle) * top);
    up = std::cos(angle) * top - std::sin(angle) * back;
    // END TODO(rotate-up)
}

void Camera::computeMatrices(void) {
    // BEGIN TODO(look-at)
    const glm::vec3 d = eye - target;
    const glm::vec3 x = glm::cross(up, d);
    const glm::vec3 y = glm::cross(d, x);
    const glm::mat3 columns(x / glm::length(x), y / glm::length(y), d / glm::length(d));
    glm::mat3 rows;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            rows[i][j] = columns[j][i];
    const glm::vec3 shift = -(rows * eye);
    view = glm::mat4(rows[0][0], rows[0][1], rows[0][2], 0.0f,  //
                     rows[1][0], rows[1][1], rows[1][2], 0.0f,  //
                     rows[2][0], rows[2][1], rows[2][2], 0.0f,  //
                     shift.x, shift.y, shift.z, 1.0f);
    // END TODO(look-at)
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
