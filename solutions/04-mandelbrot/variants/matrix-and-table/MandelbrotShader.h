// MandelbrotShader: the program of shaders/mandelbrot.frag and its uniforms, as code 4.10 has it
// for the circle. You hand this file in; you may add members, but keep these.
#pragma once

#include <cg/Todo.h>

#include <glm/glm.hpp>
#include <utility>

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
    /// Looks the three locations up. Called once after compile().
    void initUniforms() {
        const std::pair<const char*, GLint*> table[] = {
            {"center", &center_loc}, {"zoom", &zoom_loc}, {"maxiter", &maxiter_loc}};
        for (const auto& [name, location] : table) {
            *location = glGetUniformLocation(program, name);
        }
    }

    /// Hands center, zoom and maxiter to GL. Called before every picture, with the program in use.
    void setUniforms() {
        set(maxiter_loc, maxiter);
        set(zoom_loc, zoom);
        set(center_loc, center);
    }

private:
    static void set(GLint location, GLint value) { glUniform1i(location, value); }
    static void set(GLint location, GLfloat value) { glUniform1f(location, value); }
    static void set(GLint location, const glm::vec2& value) {
        glUniform2f(location, value.x, value.y);
    }
    // END TODO(uniforms)
};
