/****************************************************
My camera: where it is, where it looks, and its lens.
*****************************************************/
#define GLM_FORCE_RADIANS
#include <glm/glm.hpp>

#ifndef __CAMERA_H__
#define __CAMERA_H__

class Camera {
public:
    glm::vec3 eye;     // i
    glm::vec3 target;  // c
    glm::vec3 up;      // u
    float fovy;
    float aspect;
    float near;
    float far;

    glm::vec3 eye_default = glm::vec3(5.0f, 0.0f, 0.0f);
    glm::vec3 target_default = glm::vec3(0.0f, 0.0f, 0.0f);
    glm::vec3 up_default = glm::vec3(0.0f, 1.0f, 0.0f);
    float fovy_default = 30.0f;
    float aspect_default = 4.0f / 3.0f;
    float near_default = 0.01f;
    float far_default = 100.0f;

    glm::mat4 view = glm::mat4(1.0f);
    glm::mat4 proj = glm::mat4(1.0f);

    void rotateRight(const float degrees);
    void rotateUp(const float degrees);
    void computeMatrices(void);
    void reset(void);
};

#endif
