// The camera of the model viewer, chapters 7 and 8. You hand this file in.
#include "Camera.h"

#include <cg/Todo.h>

#include <cmath>

#include "rotation.h"  // your own, from 06-rotation

void Camera::rotateRight(const float degrees) {
    // BEGIN TODO(rotate-right)
    // A vector times a matrix is the transposed matrix times the vector, so the angle is negative.
    eye = target + (eye - target) * rotation(-degrees, up);
    // END TODO(rotate-right)
}

void Camera::rotateUp(const float degrees) {
    // BEGIN TODO(rotate-up)
    const glm::mat2x3 before(eye - target, up);
    const glm::mat2x3 after = rotation(degrees, glm::cross(before[0], before[1])) * before;
    eye = target + after[0];
    up = after[1];
    // END TODO(rotate-up)
}

void Camera::computeMatrices(void) {
    // BEGIN TODO(look-at)
    glm::mat4 C(1.0f);
    C[3] = glm::vec4(eye, 1.0f);
    C[2] = glm::vec4(glm::normalize(eye - target), 0.0f);
    C[1] = glm::vec4(up, 0.0f);
    C[1] -= glm::dot(C[1], C[2]) * C[2];
    C[1] /= glm::length(C[1]);
    C[0] = glm::vec4(glm::cross(glm::vec3(C[1]), glm::vec3(C[2])), 0.0f);
    view = glm::inverse(C);
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
