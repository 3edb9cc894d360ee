// The camera of the model viewer, chapters 7 and 8. You hand this file in.
#include "Camera.h"

#include <cg/Todo.h>

#include <cmath>

#include "rotation.h"  // your own, from 06-rotation

void Camera::rotateRight(const float degrees) {
    eye = target + rotation(degrees, up) * (eye - target);
}

void Camera::rotateUp(const float degrees) {
    const glm::mat3 turn = rotation(degrees, glm::cross(eye - target, up));
    eye = target + turn * (eye - target);
    up = turn * up;
}

void Camera::computeMatrices(void) {
    // BEGIN TODO(look-at)
    view = cg::todo<glm::mat4>("look-at", glm::mat4(1.0f));
    // END TODO(look-at)

    // BEGIN TODO(perspective)
    const float t = std::tan(glm::radians(fovy) / 2.0f);
    const float centre = -(1.0f / near + 1.0f / far) / 2.0f;
    const float halfDepth = (1.0f / near - 1.0f / far) / 2.0f;
    glm::mat4 R(1.0f);  // the apex goes to infinity
    R[2] = glm::vec4(0.0f, 0.0f, 0.0f, -1.0f);
    R[3] = glm::vec4(0.0f, 0.0f, -1.0f, 0.0f);
    glm::mat4 T(1.0f);  // the centre of the box goes to the origin
    T[3][2] = -centre;
    glm::mat4 S(1.0f);  // the half sides become 1
    S[0][0] = 1.0f / (aspect * t);
    S[1][1] = 1.0f / t;
    S[2][2] = 1.0f / halfDepth;
    proj = S * T * R;
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
