// Recursion with the current path in a static set. The guard throws, and does not tidy up before.
#include "Scene.h"

#include <set>
#include <stdexcept>

static std::set<Node*> onPath;

static void visit(Scene& scene, Node* current, const glm::mat4& matrix) {
    if (!onPath.insert(current).second) {
        throw std::runtime_error("the scene graph has a cycle");
    }
    for (std::size_t i = 0; i < current->models.size(); ++i) {
        scene.shader->modelview = matrix * current->modeltransforms[i];
        scene.shader->material = current->models[i]->material;
        scene.shader->setUniforms();
        current->models[i]->geometry->draw();
    }
    for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
        visit(scene, current->childnodes[j], matrix * current->childtransforms[j]);
    }
    onPath.erase(current);
}

void Scene::draw(void) {
    visit(*this, node["world"], camera->view);
}
