// Level by level: a list that grows while it is read. Each entry knows the entry that it came from,
// so the guard walks up through its ancestors. An error of another type; no fences.
#include "Scene.h"

#include <stdexcept>

void Scene::draw() {
    struct Entry {
        const Node* node;
        glm::mat4 modelview;
        int parent;  // index in the list, -1 for the world
    };
    std::vector<Entry> entries;
    entries.push_back(Entry{node.at("world"), camera->view, -1});

    for (int k = 0; k < static_cast<int>(entries.size()); ++k) {
        // A copy: the list may move when it grows.
        const Entry here = entries[k];
        for (int up = here.parent; up != -1; up = entries[up].parent) {
            if (entries[up].node == here.node) {
                throw std::logic_error("Scene::draw: a node is its own ancestor");
            }
        }
        for (std::size_t j = 0; j < here.node->childnodes.size(); ++j) {
            entries.push_back(
                Entry{here.node->childnodes[j], here.modelview * here.node->childtransforms[j], k});
        }
    }

    for (const Entry& entry : entries) {
        auto transform = entry.node->modeltransforms.begin();
        for (Model* each : entry.node->models) {
            shader->modelview = entry.modelview * *transform;
            shader->material = each->material;
            shader->setUniforms();
            each->geometry->draw();
            ++transform;
        }
    }
}
