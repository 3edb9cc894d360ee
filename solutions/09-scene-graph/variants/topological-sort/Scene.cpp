// First a topological sort of what the world reaches, then breadth-first with a queue. What is
// thrown is no std::exception.
#include "Scene.h"

#include <queue>
#include <set>

void Scene::draw(void) {
    Node* const world = node["world"];
    std::set<Node*> reached = {world};
    std::map<Node*, int> incoming;
    std::stack<Node*> pending;
    pending.push(world);
    while (!pending.empty()) {
        Node* const current = pending.top();
        pending.pop();
        for (Node* child : current->childnodes) {
            ++incoming[child];
            if (reached.insert(child).second) {
                pending.push(child);
            }
        }
    }
    std::size_t sorted = 0;
    if (incoming[world] == 0) {
        pending.push(world);
    }
    while (!pending.empty()) {
        Node* const current = pending.top();
        pending.pop();
        ++sorted;
        for (Node* child : current->childnodes) {
            if (--incoming[child] == 0) {
                pending.push(child);
            }
        }
    }
    if (sorted < reached.size()) {
        throw "no order from parents to children";
    }

    std::queue<std::pair<Node*, glm::mat4>> queue;
    queue.push({world, camera->view});
    while (!queue.empty()) {
        const auto [current, matrix] = queue.front();
        queue.pop();
        for (std::size_t i = 0; i < current->models.size(); ++i) {
            glUseProgram(shader->program);
            shader->material = current->models[i]->material;
            shader->modelview = matrix * current->modeltransforms[i];
            shader->setUniforms();
            current->models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
            queue.push({current->childnodes[j], matrix * current->childtransforms[j]});
        }
    }
}
