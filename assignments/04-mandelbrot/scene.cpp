#include "scene.h"

namespace course {

void Scene::init() {
    square_.init(glm::vec2(0.0f, 0.0f), 2.0f);
    shader.read_source("shaders/canvas.vert", "shaders/mandelbrot.frag");
    shader.compile();
    glUseProgram(shader.program);
    shader.initUniforms();
}

void Scene::draw() {
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(shader.program);
    shader.setUniforms();
    square_.draw();
}

}  // namespace course
