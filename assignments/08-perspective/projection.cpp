// Projections and homogeneous coordinates, chapter 8. You hand this file in.
// The third task of this chapter, `perspective`, is in your Camera.cpp of 07-camera.
#include "projection.h"

#include <cg/Todo.h>

glm::mat4 orthographic(const float height, const float aspect, const float n, const float f) {
    // BEGIN TODO(orthographic)
    // Scale and move the box onto the viewing box [-1, 1]^3. Until then: the box of code 7.3.
    (void)height;  // delete these three lines, too
    (void)n;
    (void)f;
    return cg::todo<glm::mat4>("orthographic", glm::mat4(1.0f / aspect, 0.0f, 0.0f, 0.0f,  //
                                                         0.0f, 1.0f, 0.0f, 0.0f,           //
                                                         0.0f, 0.0f, -0.1f, 0.0f,          //
                                                         0.0f, 0.0f, 0.0f, 1.0f));
    // END TODO(orthographic)
}

// BEGIN TODO(homogeneous)
// Four short functions, eqs. (8.6)-(8.8) and note 8.1. Delete the todo of each as you fill it.
glm::vec4 homogenise(const glm::vec3 p) {
    (void)p;
    return cg::todo<glm::vec4>("homogeneous", glm::vec4(0.0f));
}

glm::vec3 dehomogenise(const glm::vec4 p) {
    return cg::todo<glm::vec3>("homogeneous", glm::vec3(p));
}

glm::vec4 pointAtInfinity(const glm::vec3 direction) {
    (void)direction;
    return cg::todo<glm::vec4>("homogeneous", glm::vec4(0.0f));
}

bool isAtInfinity(const glm::vec4 p) {
    (void)p;
    return cg::todo<bool>("homogeneous", false);
}
// END TODO(homogeneous)
