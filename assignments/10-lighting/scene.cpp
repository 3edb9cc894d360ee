#include "scene.h"

#include <cg/gl.h>

#include <glm/gtc/matrix_transform.hpp>
#include <list>

namespace course {

namespace {

const glm::vec4 background(0.1f, 0.2f, 0.3f, 1.0f);
constexpr std::size_t slots = 10;

// Lights nobody looks at: black, and with a direction that can be normalised.
const glm::vec4 nowhere(0.6f, 0.64f, 0.48f, 0.0f);

glm::mat4 placed(const glm::vec3& where, float degrees, const glm::vec3& axis,
                 const glm::vec3& size) {
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), where);
    return glm::scale(glm::rotate(moved, glm::radians(degrees), axis), size);
}

}  // namespace

void LightingShader::setAllUniforms() {
    setUniforms();
    glUniform3fv(glGetUniformLocation(program, "attenuation"), 1, &attenuation[0]);
    glUniform1f(glGetUniformLocation(program, "exposure"), exposure);
    glUniform1f(glGetUniformLocation(program, "gamma"), gamma);
}

Material material(const glm::vec3& ambient, const glm::vec3& diffuse, const glm::vec3& specular,
                  const glm::vec3& emision, float shininess) {
    Material made;
    made.ambient = glm::vec4(ambient, 1.0f);
    made.diffuse = glm::vec4(diffuse, 1.0f);
    made.specular = glm::vec4(specular, 1.0f);
    made.emision = glm::vec4(emision, 1.0f);
    made.shininess = shininess;
    return made;
}

Light light(const glm::vec4& position, const glm::vec3& color) {
    Light made;
    made.position = position;
    made.color = glm::vec4(color, 1.0f);
    return made;
}

void Set::init() {
    sphere.slices = 144;  // fine enough to show a highlight even with unnormalised normals
    sphere.stacks = 72;
    sphere.init();
    torus.init();
    cube.init();
    teapot.init("models/teapot.obj");
    shader.read_source("shaders/projective.vert", "shaders/lighting.frag");
    shader.compile();
    shader.initUniforms();
    shader.enablelighting = GL_TRUE;
}

void Set::draw(const glm::mat4& view, const glm::mat4& projection, const std::vector<Light>& lights,
               const std::vector<Item>& items) {
    glClearColor(background.r, background.g, background.b, background.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(shader.program);
    shader.view = view;
    shader.projection = projection;
    shader.nlights = static_cast<GLint>(lights.size());
    shader.lightpositions.clear();
    shader.lightcolors.clear();
    for (const auto& list : {lights, stale}) {
        for (const Light& each : list) {
            shader.lightpositions.push_back(each.position);
            shader.lightcolors.push_back(each.color);
        }
    }
    shader.lightpositions.resize(slots, nowhere);
    shader.lightcolors.resize(slots, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    for (const Item& item : items) {
        shader.modelview = view * item.model;
        shader.material = item.material;
        shader.setAllUniforms();
        item.shape->draw();
    }
}

void StillLife::place(Camera& camera) {
    camera.eye_default = glm::vec3(0.9f, 1.9f, 3.5f);
    camera.target_default = target;
    // Upright, and orthogonal to the line of sight.
    const glm::vec3 z = glm::normalize(camera.eye_default - target), y(0.0f, 1.0f, 0.0f);
    camera.up_default = glm::normalize(y - glm::dot(y, z) * z);
    camera.fovy_default = fovyDegrees;
    camera.near_default = 0.1f;
    camera.far_default = 50.0f;
    camera.reset();
}

std::vector<Light> StillLife::lamps() {
    return {light({-0.5f, 0.7f, 0.6f, 0.0f}, {0.55f, 0.5f, 0.4f}),
            light({0.2f, 1.1f, 1.5f, 1.0f}, {0.35f, 0.45f, 0.75f}),
            light({3.0f, 2.6f, -0.4f, 2.0f}, {0.75f, 0.35f, 0.3f})};
}

void StillLife::draw(const glm::mat4& view, const glm::mat4& projection,
                     const std::vector<Light>& lamps) {
    const glm::vec3 none(0.0f), y(0.0f, 1.0f, 0.0f);
    Material wood =
        material({0.1f, 0.07f, 0.05f}, {0.55f, 0.4f, 0.25f}, {0.1f, 0.1f, 0.1f}, none, 8);
    Material china =
        material({0.1f, 0.1f, 0.12f}, {0.6f, 0.6f, 0.65f}, {0.5f, 0.5f, 0.5f}, none, 25);
    Material brass =
        material({0.12f, 0.1f, 0.03f}, {0.5f, 0.4f, 0.1f}, {0.7f, 0.6f, 0.3f}, none, 12);
    Material coal = material({0.05f, 0.05f, 0.05f}, {0.25f, 0.2f, 0.2f}, {0.4f, 0.4f, 0.4f},
                             {0.3f, 0.08f, 0.02f}, 10);
    if (finish_ == Finish::matt) {
        for (Material* each : {&wood, &china, &brass, &coal}) {
            each->specular = glm::vec4(none, 1.0f);
        }
    }
    std::vector<Item> items{
        {&set_.cube, placed({0.0f, -0.06f, 0.0f}, 15.0f, y, {3.4f, 0.1f, 2.4f}), &wood},
        {&set_.teapot, placed({-0.6f, 0.265f, -0.15f}, -35.0f, y, glm::vec3(0.035f)), &china},
        {&set_.torus, placed({0.8f, 0.42f, -0.35f}, 60.0f, {1.0f, 0.4f, 0.2f}, {0.4f, 0.6f, 0.3f}),
         &brass},
        {&set_.sphere,
         placed({0.45f, 0.18f, 0.65f}, 25.0f, {0.3f, 0.2f, 1.0f}, {0.45f, 0.18f, 0.25f}), &coal}};
    std::list<Material> glows;  // pointers to these must hold
    for (const Light& lamp : lamps) {
        if (lamp.position.w == 0.0f) {
            continue;
        }
        glows.push_back(material(none, none, none, glm::vec3(lamp.color), 10.0f));
        const glm::vec3 where = glm::vec3(lamp.position) / lamp.position.w;
        items.push_back(
            {&set_.cube, placed(where, 30.0f, {1, 1, 0}, glm::vec3(0.08f)), &glows.back()});
    }
    set_.draw(view, projection, lamps, items);
}

}  // namespace course
