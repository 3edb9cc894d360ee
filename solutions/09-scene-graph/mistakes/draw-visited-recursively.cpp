    std::set<Node*> visited;
    std::function<void(Node*, const glm::mat4&)> visit = [&](Node* current, const glm::mat4& matrix) {
        if (!visited.insert(current).second) {
            return;
        }
        for (std::size_t i = 0; i < current->models.size(); ++i) {
            shader->modelview = matrix * current->modeltransforms[i];
            shader->material = current->models[i]->material;
            shader->setUniforms();
            current->models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j < current->childnodes.size(); ++j) {
            visit(current->childnodes[j], matrix * current->childtransforms[j]);
        }
    };
    visit(node["world"], camera->view);
