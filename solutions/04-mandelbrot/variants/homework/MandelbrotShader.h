#ifndef MANDELBROT_SHADER_H
#define MANDELBROT_SHADER_H

#include <glm/glm.hpp>

#include "Shader.h"

struct MandelbrotShader : Shader {
    glm::vec2 center = glm::vec2(-0.5f, 0.0f);
    GLuint center_loc;
    GLfloat zoom = 1.5f;
    GLuint zoom_loc;
    GLint maxiter = 200;
    GLuint maxiter_loc;

    void initUniforms();
    void setUniforms();
};

inline void MandelbrotShader::initUniforms() {
    center_loc = glGetUniformLocation(program, "center");
    zoom_loc = glGetUniformLocation(program, "zoom");
    maxiter_loc = glGetUniformLocation(program, "maxiter");
}

inline void MandelbrotShader::setUniforms() {
    glUniform2fv(center_loc, 1, &center[0]);
    glUniform1fv(zoom_loc, 1, &zoom);
    glUniform1iv(maxiter_loc, 1, &maxiter);
}

#endif
