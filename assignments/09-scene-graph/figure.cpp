#include "figure.h"

#include <cg/gl.h>

namespace course {

void use(Look look, Scene& scene) {
    const bool normals = look == Look::normals;
    SurfaceShader& shader = *scene.shader;
    shader.read_source("shaders/projective.vert",
                       normals ? "shaders/normal.frag" : "shaders/material.frag");
    shader.compile();
    glUseProgram(shader.program);
    shader.initUniforms();
}

void look(Scene& scene, const Viewpoint& from) {
    Camera& camera = *scene.camera;
    camera.eye_default = from.eye;
    camera.target_default = from.target;
    camera.up_default = glm::vec3(0.0f, 1.0f, 0.0f);
    camera.fovy_default = 34.0f;
    camera.near_default = 0.1f;
    camera.far_default = 50.0f;
    camera.reset();
}

void prepare(Scene& scene, float aspect) {
    glClearColor(0.1f, 0.2f, 0.3f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);

    SurfaceShader& shader = *scene.shader;
    glUseProgram(shader.program);
    scene.camera->aspect = aspect;
    scene.camera->computeMatrices();
    shader.view = scene.camera->view;
    shader.projection = scene.camera->proj;
    shader.lightpositions.clear();
    shader.lightcolors.clear();
    for (const auto& [name, light] : scene.light) {
        shader.lightpositions.push_back(light->position);
        shader.lightcolors.push_back(light->color);
    }
    shader.nlights = GLint(scene.light.size());
    shader.enablelighting = GL_TRUE;
}

}  // namespace course
