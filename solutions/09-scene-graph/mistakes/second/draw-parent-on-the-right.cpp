    std::function<void(const Node*, const glm::mat4&)> visit = [&](const Node* n,
                                                                   const glm::mat4& toEye) {
        for (std::size_t k = 0; k != n->models.size(); ++k) {
            shader->material = n->models[k]->material;
            shader->modelview = toEye * n->modeltransforms[k];
            shader->setUniforms();
            n->models[k]->geometry->draw();
        }
        for (std::size_t k = 0; k != n->childnodes.size(); ++k) {
            glm::mat4 below = n->childtransforms[k];
            below *= toEye;
            visit(n->childnodes[k], below);
        }
    };
    visit(node["world"], camera->view);
