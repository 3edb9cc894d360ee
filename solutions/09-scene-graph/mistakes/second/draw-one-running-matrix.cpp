    glm::mat4 toEye = camera->view;
    std::function<void(const Node&)> enter = [&](const Node& here) {
        std::size_t k = 0;
        for (const Model* m : here.models) {
            shader->modelview = toEye * here.modeltransforms[k++];
            shader->material = m->material;
            shader->setUniforms();
            m->geometry->draw();
        }
        for (const glm::mat4& step : here.childtransforms) {
            toEye *= step;
        }
        for (auto below = here.childnodes.rbegin(); below != here.childnodes.rend(); ++below) {
            enter(**below);
        }
    };
    enter(*node["world"]);
