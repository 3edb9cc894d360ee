    const auto go = [this](auto&& self, Node* n, glm::mat4 toCamera) -> void {
        for (std::size_t i = 0; i < n->models.size(); ++i) {
            const auto& [geometry, material] = *n->models[i];
            shader->material = material;
            shader->modelview = toCamera * n->modeltransforms[i];
            geometry->draw();
        }
        for (std::size_t j = 0; j < n->childnodes.size(); ++j) {
            self(self, n->childnodes[j], toCamera * n->childtransforms[j]);
        }
    };
    go(go, node["world"], camera->view);
