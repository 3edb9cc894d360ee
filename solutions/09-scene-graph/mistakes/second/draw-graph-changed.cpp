    std::function<void(Node*, const glm::mat4&)> place = [&](Node* n, const glm::mat4& VM) {
        for (glm::mat4& M : n->modeltransforms) {
            M = VM * M;
        }
        for (std::size_t i = 0; i < n->models.size(); ++i) {
            shader->material = n->models[i]->material;
            shader->modelview = n->modeltransforms[i];
            shader->setUniforms();
            n->models[i]->geometry->draw();
        }
        for (std::size_t j = n->childnodes.size(); j-- > 0;) {
            place(n->childnodes[j], VM * n->childtransforms[j]);
        }
    };
    place(node["world"], camera->view);
