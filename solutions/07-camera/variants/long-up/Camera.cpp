#include "Camera.h"

#include "rotation.h"

void Camera::rotateRight(const float degrees) {
    eye -= target;
    eye = rotation(degrees, glm::normalize(up)) * eye;
    eye += target;
}

// up comes back orthogonal to the line of sight, but as long as the distance times that length.
void Camera::rotateUp(const float degrees) {
    const glm::vec3 right = glm::normalize(glm::cross(up, eye - target));
    const glm::vec3 arm = glm::transpose(rotation(degrees, right)) * (eye - target);
    eye = target + arm;
    up = glm::cross(arm, right);
}

void Camera::computeMatrices(void) {
    const glm::vec3 forward = glm::normalize(target - eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, up));
    up = glm::normalize(glm::cross(right, forward));
    view[0] = glm::vec4(right.x, up.x, -forward.x, 0.0f);
    view[1] = glm::vec4(right.y, up.y, -forward.y, 0.0f);
    view[2] = glm::vec4(right.z, up.z, -forward.z, 0.0f);
    view[3] = glm::vec4(glm::dot(right, -eye), glm::dot(up, -eye), glm::dot(forward, eye), 1.0f);
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
