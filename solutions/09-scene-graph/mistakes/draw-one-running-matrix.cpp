    std::stack<Node*> nodes;
    nodes.push(node["world"]);
    glm::mat4 matrix = camera->view;
    while (!nodes.empty()) {
        const Node* const current = nodes.top();
        nodes.pop();
        for (std::size_t i = 0; i < current->models.size(); ++i) {
            shader->modelview = matrix * current->modeltransforms[i];
            shader->material = current->models[i]->material;
            shader->setUniforms();
            current->models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
            nodes.push(current->childnodes[j]);
            matrix = matrix * current->childtransforms[j];
        }
    }
