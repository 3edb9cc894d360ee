// Camera: what a viewer needs to know of its camera, and the two matrices that follow from it
// (codes 7.1 and 8.1). You hand this file in; you may add members, but keep these.
#pragma once

#include <glm/glm.hpp>

class Camera {
public:
    glm::vec3 eye;     // where the camera is
    glm::vec3 target;  // the point that it looks at
    glm::vec3 up;      // roughly the top of the picture; need not be orthogonal or of length 1
    float fovy;        // vertical field of view, in degrees
    float aspect;      // width / height of the picture
    float near;        // distance to the near clipping plane, > 0
    float far;         // distance to the far clipping plane, > near

    // What reset() goes back to.
    glm::vec3 eye_default = glm::vec3(5.0f, 0.0f, 0.0f);
    glm::vec3 target_default = glm::vec3(0.0f, 0.0f, 0.0f);
    glm::vec3 up_default = glm::vec3(0.0f, 1.0f, 0.0f);
    float fovy_default = 30.0f;
    float aspect_default = 4.0f / 3.0f;
    float near_default = 0.01f;
    float far_default = 100.0f;

    glm::mat4 view = glm::mat4(1.0f);  // from world to camera coordinates
    glm::mat4 proj = glm::mat4(1.0f);  // from camera coordinates to the viewing box

    /// Moves the eye to the camera's right (positive) or left, `degrees` about the axis through
    /// target along up. target and up stay.
    void rotateRight(const float degrees);

    /// Moves the eye towards up (positive) or away from it, `degrees` about the axis through
    /// target that is orthogonal to up and eye - target. up turns with the eye, target stays.
    void rotateUp(const float degrees);

    /// Sets view from eye, target and up, eqs. (7.29)-(7.36), and proj from the other four,
    /// eq. (8.23). Calling it twice gives the same matrices.
    void computeMatrices(void);

    /// Goes back to the default values. The matrices follow with the next computeMatrices().
    void reset(void);

private:
    void computeView(void);
    void computeProjection(void);
    float slope(void) const;  // of the upper side of the frustum
};
