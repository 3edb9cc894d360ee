    std::stack<std::tuple<Node*, glm::mat4, int>> open;
    open.push({node["world"], camera->view, 100});
    while (!open.empty()) {
        const auto [here, VM, left] = open.top();
        open.pop();
        auto M = here->modeltransforms.cbegin();
        for (const Model* model : here->models) {
            shader->modelview = VM * *M++;
            shader->material = model->material;
            shader->setUniforms();
            model->geometry->draw();
        }
        if (left == 0) {
            continue;
        }
        auto T = here->childtransforms.cbegin();
        for (Node* below : here->childnodes) {
            open.push({below, VM * *T++, left - 1});
        }
    }
