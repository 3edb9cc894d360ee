#ifndef MANDELBROT_SHADER_H
#define MANDELBROT_SHADER_H
#include <glm/glm.hpp>
#include "Shader.h"

class MandelbrotShader : public Shader {
public:
    glm::vec2 center = glm::vec2(0.0, 0.0);
    GLuint center_loc;
    GLfloat zoom = 2.0;
    GLuint zoom_loc;
    GLint maxiter = 100;
    GLuint maxiter_loc;
    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
        maxiter_loc = glGetUniformLocation(program, "maxiter");
    }
    void setUniforms() {
        glUniform2f(center_loc, center[0], center[1]);
        glUniform1f(zoom_loc, zoom);
        glUniform1i(maxiter_loc, maxiter);
    }
};

#endif
