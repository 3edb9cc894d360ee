#include "scene.h"

#include <cg/gl.h>

#include <glm/gtc/matrix_transform.hpp>

namespace course {

namespace {

const glm::vec4 background(0.1f, 0.2f, 0.3f, 1.0f);

glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

glm::mat4 turned(const glm::mat4& placement, float degrees, const glm::vec3& axis) {
    return glm::rotate(placement, glm::radians(degrees), axis);
}

}  // namespace

void Scene::init() {
    cube_.init();
    shader_.read_source("shaders/projective.vert", "shaders/normal.frag");
    shader_.compile();
    shader_.initUniforms();
}

void Scene::begin(const glm::mat4& projection) {
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(shader_.program);
    shader_.projection = projection;
}

void Scene::draw(const glm::mat4& view, const glm::mat4& projection) {
    begin(projection);
    // The notes' cube, and a plate before and one behind it, drawn in neither order of depth. Each
    // plate shows another of its own faces to the camera and so has another colour.
    const glm::mat4 cube(1.0f);
    const glm::mat4 before = turned(at(-0.45f, 0.45f, 1.1f), -90.0f, glm::vec3(0, 1, 0));
    const glm::mat4 behind = turned(at(-0.5f, 0.3f, -1.6f), 90.0f, glm::vec3(1, 0, 0));
    box(view * cube, glm::vec3(1.0f));
    box(view * before, glm::vec3(0.1f, 0.5f, 0.5f));
    box(view * behind, glm::vec3(1.6f, 0.1f, 1.6f));
    // A beam that comes from behind the camera and leaves through the far plane.
    box(view * at(0.55f, -0.5f, 0.0f), glm::vec3(0.2f, 0.2f, 14.0f));
    // Posts of one size, a step of 1.2 apart.
    for (int i = 0; i < 5; ++i) {
        const glm::mat4 post = at(1.1f, 0.1f, 1.6f - 1.2f * float(i));
        box(view * turned(post, 45.0f, glm::vec3(0, 1, 0)), glm::vec3(0.15f, 1.2f, 0.15f));
    }
}

void Scene::drawPoints(const std::vector<glm::vec3>& points, const glm::mat4& view,
                       const glm::mat4& projection) {
    begin(projection);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float size = i + 1 == points.size() ? 0.3f : 0.15f;
        box(view * glm::translate(glm::mat4(1.0f), points[i]), glm::vec3(size));
    }
}

void Scene::box(const glm::mat4& placement, const glm::vec3& size) {
    shader_.modelview = glm::scale(placement, size);
    shader_.setUniforms();
    cube_.draw();
}

}  // namespace course
