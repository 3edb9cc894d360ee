#include "scene.h"

#include <cg/gl.h>

#include <glm/gtc/matrix_transform.hpp>

namespace course {

namespace {

const glm::vec4 background(0.1f, 0.2f, 0.3f, 1.0f);

void clear() {
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
}

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
    clear();
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

void NormalScene::init() {
    cube_.init();
    sphere_.init();
    shader_.read_source("shaders/transformed_normal.vert", "shaders/normal.frag");
    shader_.compile();
    shader_.initUniforms();
}

void NormalScene::draw(const glm::mat4& view, const glm::mat4& projection) {
    clear();
    glUseProgram(shader_.program);
    shader_.projection = projection;
    const auto solid = [&](Geometry& shape, const glm::vec3& where, const glm::mat4& model) {
        shader_.modelview = view * glm::translate(glm::mat4(1.0f), where) * model;
        shader_.setUniforms();
        shape.draw();
    };
    const glm::mat4 one(1.0f);
    const glm::mat4 turn = glm::rotate(one, glm::radians(35.0f), glm::vec3(0.4f, 0.2f, 1.0f));
    glm::mat4 shear(1.0f);
    shear[1] = glm::vec4(0.8f, 1.0f, 0.3f, 0.0f);
    solid(sphere_, {-0.45f, 0.35f, 0.0f}, turn * glm::scale(one, glm::vec3(0.55f, 0.15f, 0.3f)));
    solid(sphere_, {0.5f, -0.35f, 0.3f}, glm::scale(shear, glm::vec3(0.25f, 0.4f, 0.15f)));
    solid(cube_, {0.55f, 0.45f, -0.2f}, shear * turn * glm::scale(one, glm::vec3(0.3f)));
    solid(cube_, {-0.5f, -0.4f, 0.2f},
          glm::scale(one, glm::vec3(0.9f, 0.3f, 0.5f)) * turn * glm::scale(one, glm::vec3(0.6f)));
}

}  // namespace course
