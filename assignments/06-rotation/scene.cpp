#include "scene.h"

#include <cg/gl.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace course {

namespace {

const glm::vec4 background(0.1f, 0.2f, 0.3f, 1.0f);

// A fixed camera, in front of the body, a little to the right and above.
const glm::mat4 view =
    glm::lookAt(glm::vec3(1.8f, 1.5f, 4.0f), glm::vec3(0.0f), glm::vec3(0, 1, 0));

// Orthographic, 2.6 units high, depth -10 to 10.
glm::mat4 projection(float aspect) {
    const float scale = 1.0f / 1.3f;
    return glm::scale(glm::mat4(1.0f), glm::vec3(scale / aspect, scale, -0.1f));
}

}  // namespace

void Scene::init() {
    cube_.init();
    shader_.read_source("shaders/projective.vert", "shaders/normal.frag");
    shader_.compile();
    shader_.initUniforms();
}

void Scene::begin(float aspect) {
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(shader_.program);
    shader_.projection = projection(aspect);
}

void Scene::box(const glm::mat4& placement, const glm::vec3& center, const glm::vec3& size) {
    shader_.modelview =
        view * placement * glm::scale(glm::translate(glm::mat4(1.0f), center), size);
    shader_.setUniforms();
    cube_.draw();
}

// A cube with a nose along +z, a chimney along +y and an ear along +x: no turn looks like another.
void Scene::body(const glm::mat4& placement) {
    box(placement, glm::vec3(0.0f), glm::vec3(1.0f));
    box(placement, glm::vec3(0.1f, 0.1f, 0.7f), glm::vec3(0.3f, 0.3f, 0.4f));
    box(placement, glm::vec3(-0.25f, 0.75f, -0.1f), glm::vec3(0.25f, 0.5f, 0.25f));
    box(placement, glm::vec3(0.6f, -0.2f, 0.2f), glm::vec3(0.2f, 0.4f, 0.2f));
}

void Scene::drawBody(const glm::mat3& pose, float aspect) {
    begin(aspect);
    body(glm::mat4(pose));
}

void Scene::drawThreeBodies(const glm::mat3 (&poses)[3], float aspect) {
    begin(aspect);
    const glm::vec3 right(glm::transpose(view) * glm::vec4(1, 0, 0, 0));
    for (int i = 0; i < 3; ++i) {
        const glm::mat4 place = glm::translate(glm::mat4(1.0f), 1.08f * float(i - 1) * right);
        body(place * glm::mat4(0.62f * poses[i]));
    }
}

void Scene::drawWhirl(const glm::mat3& velocity, float aspect) {
    begin(aspect);
    const glm::mat4 here(1.0f);
    const int count = 14;
    for (int i = 0; i < count; ++i) {
        // A closed curve that is not planar, so that every entry of the matrix is seen.
        const float t = glm::radians(360.0f * float(i) / float(count));
        const glm::vec3 p(std::cos(t), 0.45f * std::sin(2.0f * t), 0.8f * std::sin(t));
        box(here, p, glm::vec3(0.18f));
        box(here, p + velocity * p / 3.0f, glm::vec3(0.10f));
    }
}

}  // namespace course
