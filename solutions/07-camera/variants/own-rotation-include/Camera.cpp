// The camera of the model viewer, chapters 7 and 8. You hand this file in.
#include "Camera.h"

#include <cg/Todo.h>

#include <cmath>

#include "rotation.h"  // your own, from 06-rotation

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    const glm::vec3 a = glm::normalize(axis);
    const float theta = glm::radians(degrees);
    glm::mat3 R;
    for (int column = 0; column < 3; ++column) {
        glm::vec3 e(0.0f);
        e[column] = 1.0f;
        R[column] = e + std::sin(theta) * glm::cross(a, e) +
                    (1.0f - std::cos(theta)) * glm::cross(a, glm::cross(a, e));
    }
    return R;
}

void Camera::rotateRight(const float degrees) {
    // BEGIN TODO(rotate-right)
    glm::vec3 arm = eye - target;
    arm = rotation(degrees, up) * arm;
    eye = target + arm;
    // END TODO(rotate-right)
}

void Camera::rotateUp(const float degrees) {
    // BEGIN TODO(rotate-up)
    glm::vec3 arm = eye - target;
    const glm::vec3 left = glm::cross(arm, up);
    arm = rotation(degrees, left) * arm;
    up = rotation(degrees, left) * up;
    eye = target + arm;
    // END TODO(rotate-up)
}

void Camera::computeMatrices(void) {
    // BEGIN TODO(look-at)
    const glm::vec3 back = glm::normalize(eye - target);
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    const glm::vec3 top = glm::cross(back, right);
    const glm::vec4 lastRow(0.0f, 0.0f, 0.0f, 1.0f);
    view = glm::transpose(glm::mat4(glm::vec4(right, -glm::dot(right, eye)),
                                    glm::vec4(top, -glm::dot(top, eye)),
                                    glm::vec4(back, -glm::dot(back, eye)), lastRow));
    // END TODO(look-at)

    // BEGIN TODO(perspective)
    // A task of chapter 8: set proj, eq. (8.23). Until then nothing shrinks with its distance.
    proj = cg::todo<glm::mat4>("perspective", glm::mat4(1.0f / aspect, 0.0f, 0.0f, 0.0f,  //
                                                        0.0f, 1.0f, 0.0f, 0.0f,           //
                                                        0.0f, 0.0f, -0.1f, 0.0f,          //
                                                        0.0f, 0.0f, 0.0f, 1.0f));
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
