    std::stack<Node*> nodes;
    std::stack<glm::mat4> matrices;
    std::set<Node*> visited;
    nodes.push(node["world"]);
    matrices.push(camera->view);
    while (!nodes.empty()) {
        Node* const current = nodes.top();
        const glm::mat4 matrix = matrices.top();
        nodes.pop();
        matrices.pop();
        if (!visited.insert(current).second) {
            continue;
        }
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
