#include "Camera.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace {

const glm::mat4 one(1.0f);

// The affine map that turns the world about an axis through a point.
glm::mat4 turnAbout(const glm::vec3& point, const glm::vec3& axis, float degrees) {
    const glm::mat4 there = glm::translate(one, point);
    const glm::mat4 home = glm::translate(one, -point);
    return there * glm::rotate(one, glm::radians(degrees), axis) * home;
}

}  // namespace

void Camera::rotateRight(const float degrees) {
    eye = glm::vec3(turnAbout(target, up, degrees) * glm::vec4(eye, 1.0f));
}

void Camera::rotateUp(const float degrees) {
    const glm::vec3 axis = glm::cross(up, eye - target);
    const glm::mat4 M = turnAbout(target, axis, -degrees);
    const glm::vec4 newEye = M * glm::vec4(eye, 1.0f);
    const glm::vec4 newUp = M * glm::vec4(up, 0.0f);
    eye = glm::vec3(newEye);
    up = glm::vec3(newUp);
}

void Camera::computeMatrices(void) {
    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    const glm::vec3 y = glm::normalize(glm::cross(z, x));
    glm::mat4 turn = one;
    turn = glm::row(turn, 0, glm::vec4(x, 0.0f));
    turn = glm::row(turn, 1, glm::vec4(y, 0.0f));
    turn = glm::row(turn, 2, glm::vec4(z, 0.0f));
    view = turn * glm::translate(one, -eye);
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
