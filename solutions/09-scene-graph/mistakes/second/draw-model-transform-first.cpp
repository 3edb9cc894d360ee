    std::deque<std::tuple<Node*, glm::mat4>> queue;
    queue.emplace_back(node["world"], camera->view);
    for (; !queue.empty(); queue.pop_front()) {
        Node* const n = std::get<0>(queue.front());
        const glm::mat4 A = std::get<1>(queue.front());
        for (std::size_t j = 0; j < n->childnodes.size(); ++j) {
            queue.emplace_back(n->childnodes[j], A * n->childtransforms[j]);
        }
        for (std::size_t i = 0; i < n->models.size(); ++i) {
            glm::mat4 modelview(n->modeltransforms[i]);
            modelview *= A;
            shader->modelview = modelview;
            shader->material = n->models[i]->material;
            shader->setUniforms();
            n->models[i]->geometry->draw();
        }
    }
