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
    // Depth-first from the world: an edge back to a node of the current path closes a cycle. A node
    // whose descendants are all known to be fine is not looked through again, so that this takes
    // one step for each edge, however many paths there are.
    std::set<Node*> onPath = {node["world"]}, fine;
    std::stack<std::pair<Node*, std::size_t>> path;  // each node with its next edge
    path.push({node["world"], 0});
    while (!path.empty()) {
        Node* const current = path.top().first;
        if (path.top().second == current->childnodes.size()) {
            onPath.erase(current);
            fine.insert(current);
            path.pop();
            continue;
        }
        Node* const child = current->childnodes[path.top().second++];
        if (onPath.count(child) > 0) {
            throw std::runtime_error("the scene graph has a cycle");
        }
        if (fine.count(child) == 0) {
            onPath.insert(child);
            path.push({child, 0});
        }
    }
    // END TODO(acyclic)

    // BEGIN TODO(draw)
    // Algorithm 9.3: matrices.top() is the modelview matrix of nodes.top(), eq. (9.6).
    std::stack<Node*> nodes;
    std::stack<glm::mat4> matrices;
    nodes.push(node["world"]);
    matrices.push(camera->view);
    while (!nodes.empty()) {
        const Node* const current = nodes.top();
        const glm::mat4 matrix = matrices.top();
        nodes.pop();
        matrices.pop();
        for (std::size_t i = 0; i < current->models.size(); ++i) {
            shader->modelview = matrix * current->modeltransforms[i];
            shader->material = current->models[i]->material;
            shader->setUniforms();
            current->models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
            nodes.push(current->childnodes[j]);
            matrices.push(matrix * current->childtransforms[j]);
        }
    }
    // END TODO(draw)
}
