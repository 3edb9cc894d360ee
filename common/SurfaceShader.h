#pragma once

#include <glm/glm.hpp>

#include <vector>

#include "Material.h"
#include "Shader.h"

/// Shader for surfaces with a material and lights. Each member is the uniform of the same name; the
/// material's five members are uniforms of their own (ambient ... shininess). After compile():
///     glUseProgram(shader.program);
///     shader.initUniforms();
/// then, before each draw, set the members and call shader.setUniforms(). A uniform that the
/// program does not have is left out, so the class also drives shaders without light or material.
struct SurfaceShader : Shader {
    glm::mat4 view = glm::mat4(1.0f);        ///< world to camera coordinates
    glm::mat4 modelview = glm::mat4(1.0f);   ///< model to camera coordinates
    glm::mat4 projection = glm::mat4(1.0f);  ///< camera to clip coordinates
    Material* material = nullptr;            ///< not owned; nullptr stands for Material's defaults
    GLboolean enablelighting = GL_FALSE;
    GLint nlights = 0;                      ///< lights that count, at most the lists' length
    std::vector<glm::vec4> lightpositions;  ///< world coordinates, homogeneous
    std::vector<glm::vec4> lightcolors;     ///< linear RGB, alpha 1

    /// Looks the uniforms up; once after compile().
    void initUniforms();

    /// Hands all members to GL; the program must be in use (glUseProgram). Lists longer than 10 are
    /// cut, and so is nlights; slots that a list does not fill keep what they had.
    void setUniforms();

private:
    struct Locations {
        GLint view = -1, modelview = -1, projection = -1;
        GLint ambient = -1, diffuse = -1, specular = -1, emision = -1, shininess = -1;
        GLint enablelighting = -1, nlights = -1, lightpositions = -1, lightcolors = -1;
    };
    Locations at_;  // -1: not there, and then setting it does nothing
};
