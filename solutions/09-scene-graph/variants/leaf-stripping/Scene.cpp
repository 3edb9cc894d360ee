// The guard crosses nodes off whose children are all crossed off; the world is among them unless it
// reaches a cycle. At the same time, from the leaves upwards, each node collects what hangs below
// it, in its own coordinates: no path is ever walked.
#include "Scene.h"

#include <exception>

namespace {

struct Endless : std::exception {
    const char* what() const noexcept override { return "the scene graph has a cycle"; }
};

struct Placed {
    const Model* model;
    glm::mat4 transform;
};

}  // namespace

void Scene::draw(void) {
    std::map<const Node*, std::vector<Placed>> below;  // of every node that is crossed off
    bool changed = true;
    while (changed) {
        changed = false;
        for (const auto& entry : node) {
            const Node* const current = entry.second;
            bool ready = below.count(current) == 0;
            for (const Node* child : current->childnodes) {
                ready = ready && below.count(child) == 1;
            }
            if (!ready) {
                continue;
            }
            std::vector<Placed>& list = below[current];
            for (std::size_t i = 0; i < current->models.size(); ++i) {
                list.push_back({current->models[i], current->modeltransforms[i]});
            }
            for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
                for (const Placed& each : below[current->childnodes[j]]) {
                    list.push_back({each.model, current->childtransforms[j] * each.transform});
                }
            }
            changed = true;
        }
    }

    const auto world = below.find(node["world"]);
    if (world == below.end()) {
        throw Endless();
    }
    for (const Placed& each : world->second) {
        shader->modelview = camera->view * each.transform;
        shader->material = each.model->material;
        shader->setUniforms();
        each.model->geometry->draw();
    }
}
