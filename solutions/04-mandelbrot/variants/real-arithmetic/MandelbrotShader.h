// MandelbrotShader: the program of shaders/mandelbrot.frag and its uniforms, as code 4.10 has it
// for the circle. You hand this file in; you may add members, but keep these.
#pragma once

#include <cg/Todo.h>

#include <glm/glm.hpp>

#include "Shader.h"

class MandelbrotShader : public Shader {
public:
    glm::vec2 center = glm::vec2(0.0f, 0.0f);  // the complex number in the middle of the picture
    GLfloat zoom = 2.0f;                       // half of the picture's width, > 0
    GLint maxiter = 50;                        // n_max of the notes, > 0

    GLint center_loc = -1;  // where the program keeps its uniforms; -1: not there
    GLint zoom_loc = -1;
    GLint maxiter_loc = -1;

    // BEGIN TODO(uniforms)
    // Sets only what has changed since the last picture.
    void initUniforms() {
        maxiter_loc = glGetUniformLocation(program, "maxiter");
        zoom_loc = glGetUniformLocation(program, "zoom");
        center_loc = glGetUniformLocation(program, "center");
        isKnown = false;
    }

    void setUniforms() {
        if (!isKnown || knownCenter != center) {
            glUniform2fv(center_loc, 1, &center.x);
        }
        if (!isKnown || knownZoom != zoom) {
            glUniform1f(zoom_loc, zoom);
        }
        if (!isKnown || knownMaxiter != maxiter) {
            glUniform1i(maxiter_loc, maxiter);
        }
        isKnown = true;
        knownCenter = center;
        knownZoom = zoom;
        knownMaxiter = maxiter;
    }

    bool isKnown = false;
    glm::vec2 knownCenter = glm::vec2(0.0f);
    GLfloat knownZoom = 0.0f;
    GLint knownMaxiter = 0;
    // END TODO(uniforms)
};
