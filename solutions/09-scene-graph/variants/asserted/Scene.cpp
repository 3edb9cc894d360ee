// Recursion with the path as a list; a cycle fails an assertion, which prints a message and aborts.
#include "Scene.h"

#include <algorithm>
#include <cassert>

static void visit(SurfaceShader* shader, Node* node, const glm::mat4& matrix,
                  std::vector<Node*>& path) {
    assert(std::count(path.begin(), path.end(), node) == 0 && "the scene graph is acyclic");
    path.push_back(node);
    for (size_t i = 0; i < node->models.size(); ++i) {
        shader->modelview = matrix * node->modeltransforms[i];
        shader->material = node->models[i]->material;
        shader->setUniforms();
        node->models[i]->geometry->draw();
    }
    for (size_t j = 0; j < node->childnodes.size(); ++j)
        visit(shader, node->childnodes[j], matrix * node->childtransforms[j], path);
    path.pop_back();
}

void Scene::draw(void) {
    std::vector<Node*> path;
    visit(shader, node["world"], camera->view, path);
}
