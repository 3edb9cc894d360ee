    std::vector<std::pair<const Node*, glm::mat4>> waiting = {{node["world"], camera->view}};
    while (waiting.size() > 0) {
        const auto [n, VM] = waiting.back();
        waiting.pop_back();
        for (std::size_t i = 0; i != n->models.size(); ++i) {
            shader->material = n->models[i]->material;
            shader->modelview = VM * n->modeltransforms[i];
            shader->setUniforms();
            n->models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j != n->childnodes.size(); ++j) {
            waiting.emplace_back(n->childnodes[j], VM * n->childtransforms[j]);
        }
        if (waiting.size() > node.size()) {
            std::cout << "endless loop in the scene" << std::endl;
            return;
        }
    }
    return;
