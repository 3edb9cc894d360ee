#include "scene.h"

#include <cg/gl.h>

#include <glm/gtc/matrix_transform.hpp>

namespace course {

namespace {

const glm::vec4 background(0.1f, 0.2f, 0.3f, 1.0f);

}  // namespace

glm::mat4 projDefault(float aspect) {
    return glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / aspect, 1.0f, -0.1f));
}

void Scene::init() {
    cube_.init();
    shader_.read_source("shaders/projective.vert", "shaders/normal.frag");
    shader_.compile();
    shader_.initUniforms();
}

void Scene::draw(const glm::mat4& view, const glm::mat4& projection) {
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(shader_.program);
    shader_.projection = projection;

    box(view, glm::vec3(0.0f), glm::vec3(1.0f));
    box(view, glm::vec3(0.72f, 0.12f, 0.1f), glm::vec3(0.45f, 0.25f, 0.25f));
    box(view, glm::vec3(-0.22f, 0.68f, 0.18f), glm::vec3(0.22f, 0.4f, 0.22f));
    box(view, glm::vec3(0.15f, -0.28f, 0.8f), glm::vec3(0.2f, 0.2f, 0.6f));
}

void Scene::box(const glm::mat4& view, const glm::vec3& center, const glm::vec3& size) {
    shader_.modelview = view * glm::scale(glm::translate(glm::mat4(1.0f), center), size);
    shader_.setUniforms();
    cube_.draw();
}

}  // namespace course
