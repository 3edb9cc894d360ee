    std::function<void(Node*, glm::mat4)> show = [&](Node* here, glm::mat4 at) {
        for (std::size_t k = 0; k < here->models.size(); k++) {
            if (k > 0) {
                at *= here->modeltransforms[k - 1];
            }
            Model* const m = here->models[k];
            shader->material = m->material;
            shader->modelview = at * here->modeltransforms[k];
            shader->setUniforms();
            m->geometry->draw();
        }
        for (std::size_t k = 0; k < here->childnodes.size(); k++) {
            show(here->childnodes[k], at * here->childtransforms[k]);
        }
    };
    show(node["world"], camera->view);
