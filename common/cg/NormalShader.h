#pragma once

#include <Shader.h>

#include <glm/glm.hpp>

/// Shader of shaders/projective.vert with shaders/normal.frag: colours a surface by its normal in
/// model coordinates, eq. (7.42). Set the two matrices, then call setUniforms() before drawing.
struct NormalShader : Shader {
    glm::mat4 modelview = glm::mat4(1.0f);   ///< model to camera coordinates
    glm::mat4 projection = glm::mat4(1.0f);  ///< camera to clip coordinates

    GLint modelview_loc = -1;  ///< -1: not there, and then setting it does nothing
    GLint projection_loc = -1;

    /// Looks the uniforms up; once after compile().
    void initUniforms() {
        modelview_loc = glGetUniformLocation(program, "modelview");
        projection_loc = glGetUniformLocation(program, "projection");
    }

    /// Hands both matrices to GL; the program must be in use (glUseProgram).
    void setUniforms() {
        glUniformMatrix4fv(modelview_loc, 1, GL_FALSE, &modelview[0][0]);
        glUniformMatrix4fv(projection_loc, 1, GL_FALSE, &projection[0][0]);
    }
};
