// The scene of figure 9.1, as the script of section 9.1.3 builds it: palettes, nodes, models, and
// two lines for each arrow of the figure. Provided; everything here is inline, so that any file may
// include it.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "Cube.h"
#include "Obj.h"
#include "Scene.h"

namespace course {

inline glm::mat4 moved(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}
inline glm::mat4 scaled(float x, float y, float z) {
    return glm::scale(glm::mat4(1.0f), glm::vec3(x, y, z));
}
inline glm::mat4 turned(float degrees, const glm::vec3& axis) {
    return glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis);
}

inline void connect(Node* parent, Node* child, const glm::mat4& transform) {
    parent->childnodes.push_back(child);
    parent->childtransforms.push_back(transform);
}
inline void hang(Node* parent, Model* model, const glm::mat4& transform) {
    parent->models.push_back(model);
    parent->modeltransforms.push_back(transform);
}

inline void fillPalettes(Scene& scene) {
    scene.geometry["cube"] = new Cube;
    scene.geometry["cube"]->init();
    scene.geometry["teapot"] = new Obj;
    scene.geometry["teapot"]->init("models/teapot.obj");
    scene.geometry["bunny"] = new Obj;
    scene.geometry["bunny"]->init("models/bunny.obj");

    const auto color = [](float r, float g, float b) { return glm::vec4(r, g, b, 1.0f); };
    auto& material = scene.material;
    material["wood"] = new Material{color(.10f, .06f, .03f), color(.45f, .26f, .12f),
                                    color(.10f, .08f, .06f), color(0, 0, 0), 8.0f};
    material["silver"] = new Material{color(.12f, .12f, .13f), color(.35f, .36f, .38f),
                                      color(.80f, .80f, .85f), color(0, 0, 0), 60.0f};
    material["ceramic"] = new Material{color(.14f, .10f, .09f), color(.80f, .35f, .28f),
                                       color(.50f, .50f, .50f), color(0, 0, 0), 120.0f};
    material["turquoise"] = new Material{color(.05f, .12f, .11f), color(.25f, .62f, .58f),
                                         color(.20f, .22f, .22f), color(0, 0, 0), 16.0f};
    material["bulb"] = new Material{color(0, 0, 0), color(.10f, .10f, .10f), color(0, 0, 0),
                                    color(1.0f, .95f, .80f), 10.0f};

    scene.light["sun"] = new Light{{3.0f, 2.0f, 4.0f, 0.0f}, color(1.0f, .95f, .9f)};
    scene.light["bulb"] = new Light{{0.0f, 2.2f, 0.0f, 1.0f}, color(.7f, .65f, .5f)};
}

inline void fillModels(Scene& scene) {
    auto& model = scene.model;
    auto& geometry = scene.geometry;
    auto& material = scene.material;
    model["table piece"] = new Model{geometry["cube"], material["wood"]};
    model["teapot1"] = new Model{geometry["teapot"], material["silver"]};
    model["teapot2"] = new Model{geometry["teapot"], material["ceramic"]};
    model["bunny"] = new Model{geometry["bunny"], material["turquoise"]};
    model["bulb"] = new Model{geometry["cube"], material["bulb"]};
}

/// Six nodes, fourteen arrows, nine paths: nine models are drawn.
inline void fillGraph(Scene& scene) {
    auto& node = scene.node;  // node["world"] is there already
    auto& model = scene.model;
    for (const char* name : {"table", "table top", "table leg", "teapot1", "teapot2"}) {
        node[name] = new Node;
    }

    connect(node["table"], node["table top"], moved(0.0f, 1.0f, 0.0f));
    connect(node["table"], node["table leg"], moved(-0.85f, 0.0f, -0.45f));
    connect(node["table"], node["table leg"], moved(0.85f, 0.0f, -0.45f));
    connect(node["table"], node["table leg"], moved(-0.85f, 0.0f, 0.45f));
    connect(node["table"], node["table leg"], moved(0.85f, 0.0f, 0.45f));
    hang(node["table leg"], model["table piece"],
         moved(0.0f, 0.475f, 0.0f) * scaled(0.12f, 0.95f, 0.12f));
    hang(node["table top"], model["table piece"], scaled(2.0f, 0.1f, 1.2f));
    connect(node["table top"], node["teapot1"],
            moved(-0.45f, 0.05f, 0.15f) * turned(25.0f, glm::vec3(0.0f, 1.0f, 0.0f)));
    connect(node["table top"], node["teapot2"],
            moved(0.5f, 0.05f, -0.15f) * turned(-130.0f, glm::vec3(0.0f, 1.0f, 0.0f)));
    hang(node["teapot1"], model["teapot1"],
         moved(0.0f, 0.21f, 0.0f) * scaled(0.026f, 0.026f, 0.026f));
    hang(node["teapot2"], model["teapot2"],
         moved(0.0f, 0.15f, 0.0f) * scaled(0.018f, 0.018f, 0.018f));
    connect(node["world"], node["table"],
            moved(0.15f, 0.0f, -0.2f) * turned(15.0f, glm::vec3(0.0f, 1.0f, 0.0f)));
    hang(node["world"], model["bunny"],
         moved(-0.9f, 0.0f, 1.1f) * turned(-20.0f, glm::vec3(0.0f, 1.0f, 0.0f)) *
             scaled(0.075f, 0.075f, 0.075f));
    hang(node["world"], model["bulb"], moved(0.1f, 2.0f, -0.15f) * scaled(0.14f, 0.2f, 0.14f));
}

/// Everything of figure 9.1 but the shader and the camera. Needs a current context.
inline void buildFigure(Scene& scene) {
    fillPalettes(scene);
    fillModels(scene);
    fillGraph(scene);
}

}  // namespace course
