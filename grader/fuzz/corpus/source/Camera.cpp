// The camera of the model viewer, chapters 7 and 8. You hand this file in.
#include "Camera.h"

#include <cg/Todo.h>

#include <cmath>

#include "rotation.h"  // your own, from 06-rotation

void Camera::rotateRight(const float degrees) {
    // BEGIN TODO(rotate-right)
    // Turn eye about the axis through target along up.
    (void)degrees;  // delete this line, too
    cg::todo("rotate-right");
    // END TODO(rotate-right)
}

void Camera::rotateUp(const float degrees) {
    // BEGIN TODO(rotate-up)
    // Turn eye and up about the axis through target that is orthogonal to up and eye - target.
    // Positive angles bring the eye towards up.
    (void)degrees;
    cg::todo("rotate-up");
    // END TODO(rotate-up)
}

void Camera::computeMatrices(void) {
    // BEGIN TODO(look-at)
    // Set view, eqs. (7.29)-(7.36). Until then the camera only shifts the world and never turns it.
    view = glm::mat4(1.0f);
    view[3] = glm::vec4(-eye, 1.0f);
    view = cg::todo<glm::mat4>("look-at", view);
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
