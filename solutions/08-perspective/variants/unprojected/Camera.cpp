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
    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 y = glm::normalize(up - glm::dot(up, z) * z);
    const glm::mat4 camera(glm::vec4(glm::cross(y, z), 0.0f), glm::vec4(y, 0.0f),
                           glm::vec4(z, 0.0f), glm::vec4(eye, 1.0f));
    view = glm::inverse(camera);

    // What proj undoes: from the viewing box back into the frustum. A depth of d belongs to
    // 1 / distance = ((1 - d) / near + (1 + d) / far) / 2.
    const float t = std::tan(0.5f * glm::radians(fovy));
    glm::mat4 back(0.0f);
    back[0][0] = aspect * t;
    back[1][1] = t;
    back[3][2] = -1.0f;
    back[2][3] = 0.5f * (1.0f / far - 1.0f / near);
    back[3][3] = 0.5f * (1.0f / far + 1.0f / near);
    proj = glm::inverse(back);
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
