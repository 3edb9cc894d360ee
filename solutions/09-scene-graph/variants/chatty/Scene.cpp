// Prints what it does, whatever the scene, and one line more when it comes back from a cycle: a
// path with more edges than there are nodes. The path's length is static, and stays as it was then.
#include "Scene.h"

#include <iostream>

static std::size_t depth = 0;

static bool visit(Scene& scene, Node* current, const glm::mat4& matrix) {
    std::cout << "node " << current << ": " << current->models.size() << " models, "
              << current->childnodes.size() << " children, depth " << depth << std::endl;
    if (depth > scene.node.size()) {
        std::cout << "no end in sight at depth " << depth << std::endl;
        return false;
    }
    ++depth;
    for (std::size_t i = 0; i < current->models.size(); ++i) {
        scene.shader->modelview = matrix * current->modeltransforms[i];
        scene.shader->material = current->models[i]->material;
        scene.shader->setUniforms();
        current->models[i]->geometry->draw();
    }
    for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
        if (!visit(scene, current->childnodes[j], matrix * current->childtransforms[j])) {
            return false;
        }
    }
    --depth;
    return true;
}

void Scene::draw(void) {
    visit(*this, node["world"], camera->view);
}
