    std::vector<std::pair<const Node*, glm::mat4>> list = {{node["world"], camera->view}};
    while (!list.empty()) {
        const auto here = list.back();
        list.pop_back();
        if (!here.first->models.empty()) {
            const Model* const model = here.first->models.front();
            shader->material = model->material;
            shader->modelview = here.second * here.first->modeltransforms.front();
            shader->setUniforms();
            model->geometry->draw();
        }
        for (std::size_t j = here.first->childnodes.size(); j-- > 0;) {
            list.emplace_back(here.first->childnodes[j],
                              here.second * here.first->childtransforms[j]);
        }
    }
