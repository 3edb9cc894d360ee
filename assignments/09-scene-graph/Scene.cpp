// Scene::draw, algorithm 9.3. You hand this file in. Scene.h lists the members of Scene, Node.h and
// Model.h those of the graph.
#include "Scene.h"

#include <cg/Todo.h>

#include <map>
#include <set>
#include <stack>
#include <stdexcept>

void Scene::draw(void) {
    // BEGIN TODO(acyclic)
    // Follow the edges from node["world"]. If they lead round in a circle, say so and draw nothing:
    //     throw std::runtime_error("the scene graph has a cycle");
    cg::todo("acyclic");
    // END TODO(acyclic)

    // BEGIN TODO(draw)
    // Draw every model once for each path from node["world"] to it. Until then only what hangs
    // directly in the world is drawn.
    const Node* world = node["world"];
    for (std::size_t i = 0; i < world->models.size(); ++i) {
        shader->modelview = camera->view * world->modeltransforms[i];
        shader->material = world->models[i]->material;
        shader->setUniforms();
        world->models[i]->geometry->draw();
    }
    cg::todo("draw");
    // END TODO(draw)
}
