#include "Camera.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "rotation.h"

void Camera::rotateRight(const float degrees) {
    eye = target + rotation(degrees, up) * (eye - target);
}

void Camera::rotateUp(const float degrees) {
    const glm::mat3 turn = rotation(degrees, glm::cross(eye - target, up));
    eye = target + turn * (eye - target);
    up = turn * up;
}

// A matrix written down row after row, as on paper.
static glm::mat4 rowByRow(const float (&table)[16]) {
    return glm::transpose(glm::make_mat4(table));
}

void Camera::computeMatrices(void) {
    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    const glm::vec3 y = glm::cross(z, x);
    view = rowByRow({x.x, x.y, x.z, -glm::dot(x, eye),  //
                     y.x, y.y, y.z, -glm::dot(y, eye),  //
                     z.x, z.y, z.z, -glm::dot(z, eye),  //
                     0, 0, 0, 1});

    const float top = near * std::tan(glm::radians(fovy) / 2), right = aspect * top;
    const float depth = far - near;
    proj = rowByRow({near / right, 0, 0, 0,                                 //
                     0, near / top, 0, 0,                                   //
                     0, 0, -(near + far) / depth, -2 * near * far / depth,  //
                     0, 0, -1, 0});
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
