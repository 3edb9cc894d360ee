    std::function<void(Node*, glm::mat4)> walk = [&](Node* here, glm::mat4 toCamera) {
        for (std::size_t k = 0; k < here->models.size(); k++) {
            shader->material = here->models[k]->material;
            shader->modelview = toCamera * here->modeltransforms[k];
            shader->setUniforms();
        }
        for (std::size_t k = 0; k < here->childnodes.size(); k++) {
            walk(here->childnodes[k], toCamera * here->childtransforms[k]);
        }
    };
    walk(node["world"], camera->view);
