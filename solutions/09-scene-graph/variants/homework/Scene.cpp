// The traversal as existing student code has it: everything set up again in draw(), three stacks,
// the depth of the path as guard, a message and an exit.
#include "Scene.h"

#include "Scene.inl"

using namespace glm;

void Scene::draw(void) {
    camera->computeMatrices();
    shader->view = camera->view;
    shader->projection = camera->proj;
    shader->nlights = int(light.size());
    shader->lightpositions.resize(light.size());
    shader->lightcolors.resize(light.size());
    int count = 0;
    for (std::pair<std::string, Light*> entry : light) {
        shader->lightpositions[count] = entry.second->position;
        shader->lightcolors[count] = entry.second->color;
        count++;
    }

    std::stack<Node*> nodestack;
    std::stack<mat4> matrixstack;
    std::stack<size_t> depthstack;
    nodestack.push(node["world"]);
    matrixstack.push(camera->view);
    depthstack.push(1);
    while (!nodestack.empty()) {
        Node* current = nodestack.top();
        mat4 VM = matrixstack.top();
        size_t depth = depthstack.top();
        nodestack.pop();
        matrixstack.pop();
        depthstack.pop();
        if (depth > node.size()) {
            std::cerr << "Error: a closed loop in the scene graph." << std::endl;
            exit(-1);
        }
        for (size_t i = 0; i < current->models.size(); i++) {
            shader->modelview = VM * current->modeltransforms[i];
            shader->material = current->models[i]->material;
            shader->setUniforms();
            current->models[i]->geometry->draw();
        }
        for (size_t i = 0; i < current->childnodes.size(); i++) {
            nodestack.push(current->childnodes[i]);
            matrixstack.push(VM * current->childtransforms[i]);
            depthstack.push(depth + 1);
        }
    }
}
