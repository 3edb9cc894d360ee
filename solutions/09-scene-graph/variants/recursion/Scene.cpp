// Recursion, children before models, last child first; the view is multiplied at the end. The guard
// looks for the node on the current path, prints, and returns.
#include "Scene.h"

#include <algorithm>
#include <cstdio>

namespace {

bool visit(Scene& scene, Node* current, const glm::mat4& matrix, std::vector<Node*>& path) {
    if (std::find(path.begin(), path.end(), current) != path.end()) {
        std::printf("a node is below itself\n");
        return false;
    }
    path.push_back(current);
    for (std::size_t j = current->childnodes.size(); j-- > 0;) {
        if (!visit(scene, current->childnodes[j], matrix * current->childtransforms[j], path)) {
            return false;
        }
    }
    path.pop_back();
    for (std::size_t i = current->models.size(); i-- > 0;) {
        scene.shader->material = current->models[i]->material;
        scene.shader->modelview = scene.camera->view * (matrix * current->modeltransforms[i]);
        scene.shader->setUniforms();
        current->models[i]->geometry->draw();
    }
    return true;
}

}  // namespace

void Scene::draw(void) {
    std::vector<Node*> path;
    visit(*this, node["world"], glm::mat4(1.0f), path);
}
