    std::function<void(Node*, glm::mat4)> render = [&](Node* group, glm::mat4 VM) {
        if (group->models.size() > 0) {
            shader->material = group->models.front()->material;
        }
        for (std::size_t i = 0; i < group->models.size(); i++) {
            shader->modelview = VM * group->modeltransforms[i];
            shader->setUniforms();
            group->models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j < group->childnodes.size(); j++) {
            render(group->childnodes[j], VM * group->childtransforms[j]);
        }
    };
    render(node["world"], camera->view);
