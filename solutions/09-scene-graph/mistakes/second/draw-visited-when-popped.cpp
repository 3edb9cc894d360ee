    std::vector<std::pair<Node*, glm::mat4>> waiting = {{node["world"], camera->view}};
    std::vector<Node*> done;
    while (!waiting.empty()) {
        auto [n, VM] = waiting.back();
        waiting.pop_back();
        if (std::count(done.begin(), done.end(), n) == 0) {
            done.push_back(n);
            for (std::size_t j = 0; j != n->childnodes.size(); ++j) {
                waiting.emplace_back(n->childnodes[j], VM * n->childtransforms[j]);
            }
            for (std::size_t i = 0; i != n->models.size(); ++i) {
                shader->material = n->models[i]->material;
                shader->modelview = VM * n->modeltransforms[i];
                shader->setUniforms();
                n->models[i]->geometry->draw();
            }
        }
    }
