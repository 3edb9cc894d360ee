    std::function<void(const Node*, glm::mat4)> descend = [&](const Node* n, glm::mat4 VM) {
        for (std::size_t i = n->models.size(); i > 0; i--) {
            const Model* piece = n->models[i - 1];
            shader->modelview = VM * n->modeltransforms[i - 1];
            shader->material = piece->material;
            shader->setUniforms();
            piece->geometry->draw();
        }
        if (n->childnodes.empty()) {
            return;
        }
        const glm::mat4 below = VM * n->childtransforms.front();
        for (const Node* child : n->childnodes) {
            descend(child, below);
        }
    };
    descend(node["world"], camera->view);
