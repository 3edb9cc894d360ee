    std::function<void(Node*, glm::mat4)> children = [&](Node* parent, glm::mat4 VM) {
        for (std::size_t j = 0; j < parent->childnodes.size(); ++j) {
            Node* const child = parent->childnodes[j];
            const glm::mat4 toCamera = VM * parent->childtransforms[j];
            for (std::size_t i = 0; i < child->models.size(); ++i) {
                shader->material = child->models[i]->material;
                shader->modelview = toCamera * child->modeltransforms[i];
                shader->setUniforms();
                child->models[i]->geometry->draw();
            }
            children(child, toCamera);
        }
    };
    children(node["world"], camera->view);
