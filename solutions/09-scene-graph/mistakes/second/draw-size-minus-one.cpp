    std::function<void(Node*, glm::mat4)> traverse = [&](Node* current_node, glm::mat4 A) {
        const std::vector<Model*>& models = current_node->models;
        const std::size_t last = models.size() - 1;
        std::size_t i = 0;
        while (i <= last) {
            const glm::mat4 M = current_node->modeltransforms[i];
            shader->modelview = A * M;
            shader->material = models[i]->material;
            shader->setUniforms();
            models[i]->geometry->draw();
            i++;
        }
        std::size_t j = 0;
        for (Node* child : current_node->childnodes) {
            traverse(child, A * current_node->childtransforms[j++]);
        }
    };
    traverse(node["world"], camera->view);
