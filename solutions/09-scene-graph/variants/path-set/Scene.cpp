// One stack whose entries are edges still to follow or orders to leave a node, so that the set of
// nodes on the path is right at any time. Throws a class of its own while already drawing.
#include "Scene.h"

#include <set>

class CycleError {
public:
    explicit CycleError(const std::string& where) : where_(where) {}
    const std::string& where() const { return where_; }

private:
    std::string where_;
};

struct Todo {
    Node* node;
    glm::mat4 matrix;
    bool leave;
};

void Scene::draw(void) {
    std::set<Node*> path;
    std::stack<Todo> todo;
    todo.push({node["world"], camera->view, false});
    while (!todo.empty()) {
        Todo now = todo.top();
        todo.pop();
        if (now.leave) {
            path.erase(now.node);
            continue;
        }
        if (path.find(now.node) != path.end()) {
            for (auto& entry : node) {
                if (entry.second == now.node) {
                    throw CycleError(entry.first);
                }
            }
            throw CycleError("a node without a name");
        }
        path.insert(now.node);
        todo.push({now.node, now.matrix, true});

        for (unsigned int i = 0; i < now.node->models.size(); i++) {
            Model* m = now.node->models[i];
            shader->modelview = now.matrix * now.node->modeltransforms[i];
            shader->material = m->material;
            shader->setUniforms();
            m->geometry->draw();
        }
        for (unsigned int j = 0; j < now.node->childnodes.size(); j++) {
            todo.push({now.node->childnodes[j], now.matrix * now.node->childtransforms[j], false});
        }
    }
}
