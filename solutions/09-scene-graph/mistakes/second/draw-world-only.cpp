    std::stack<std::pair<Node*, glm::mat4>> todo;
    todo.emplace(node.at("world"), camera->view);
    while (!todo.empty()) {
        auto [here, VM] = todo.top();
        todo.pop();
        auto transform = here->modeltransforms.begin();
        for (Model* m : here->models) {
            shader->modelview = VM * *transform++;
            shader->material = m->material;
            shader->setUniforms();
            m->geometry->draw();
        }
    }
