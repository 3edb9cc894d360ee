    std::function<void(Node*, const glm::mat4&)> follow = [&](Node* parent, const glm::mat4& VM) {
        for (std::size_t i = 0; i < parent->models.size(); ++i) {
            shader->modelview = VM * parent->modeltransforms[i];
            shader->material = parent->models[i]->material;
            shader->setUniforms();
            parent->models[i]->geometry->draw();
        }
        std::map<Node*, glm::mat4> transformOf;
        for (std::size_t j = 0; j < parent->childnodes.size(); ++j) {
            transformOf.emplace(parent->childnodes[j], parent->childtransforms[j]);
        }
        for (Node* child : parent->childnodes) {
            follow(child, VM * transformOf.at(child));
        }
    };
    follow(node["world"], camera->view);
