#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

/// The camera of codes 7.1 and 8.1, solved: for the chapters after 8. All of it is in the header on
/// purpose. A Camera.cpp in library cg would fill in for functions that a submission to 07-camera
/// lacks, since that one brings a class of the same name.
class Camera {
public:
    glm::vec3 eye{};      ///< where the camera is
    glm::vec3 target{};   ///< the point that it looks at
    glm::vec3 up{};       ///< not parallel to eye - target; of any length for computeMatrices()
    float fovy = 0.0f;    ///< vertical field of view, in degrees
    float aspect = 0.0f;  ///< width / height of the picture
    float near = 0.0f;    ///< distance to the near clipping plane, > 0
    float far = 0.0f;     ///< distance to the far clipping plane, > near

    // What reset() goes back to; the members above hold nothing useful before.
    glm::vec3 eye_default = glm::vec3(5.0f, 0.0f, 0.0f);
    glm::vec3 target_default = glm::vec3(0.0f, 0.0f, 0.0f);
    glm::vec3 up_default = glm::vec3(0.0f, 1.0f, 0.0f);
    float fovy_default = 30.0f;
    float aspect_default = 4.0f / 3.0f;
    float near_default = 0.01f;
    float far_default = 100.0f;

    glm::mat4 view = glm::mat4(1.0f);  ///< world to camera coordinates, eqs. (7.29)-(7.36)
    glm::mat4 proj = glm::mat4(1.0f);  ///< camera to clip coordinates, eq. (8.23)

    /// Moves the eye to the camera's right (positive), `degrees` about the axis through target
    /// along up. Wants an up that is orthogonal to eye - target.
    void rotateRight(const float degrees) { eye = target + rotation(degrees, up) * (eye - target); }

    /// Moves the eye towards up (positive), `degrees` about the axis through target that is
    /// orthogonal to up and eye - target; up turns with it.
    void rotateUp(const float degrees) {
        const glm::mat3 R = rotation(-degrees, glm::cross(up, eye - target));
        eye = target + R * (eye - target);
        up = R * up;
    }

    /// Sets view from eye, target and up, and proj from the other four.
    void computeMatrices(void) {
        view = glm::lookAt(eye, target, up);
        proj = glm::perspective(glm::radians(fovy), aspect, near, far);
    }

    /// Goes back to the default values. The matrices follow with the next computeMatrices().
    void reset(void) {
        eye = eye_default;
        target = target_default;
        up = up_default;
        fovy = fovy_default;
        aspect = aspect_default;
        near = near_default;
        far = far_default;
    }

private:
    static glm::mat3 rotation(float degrees, const glm::vec3& axis) {
        return glm::mat3(glm::rotate(glm::mat4(1.0f), glm::radians(degrees), glm::normalize(axis)));
    }
};
