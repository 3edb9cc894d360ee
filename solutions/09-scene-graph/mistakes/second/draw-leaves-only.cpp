    std::vector<std::pair<Node*, glm::mat4>> found;
    found.emplace_back(node["world"], camera->view);
    for (std::size_t k = 0; k < found.size(); k++) {
        const auto [here, VM] = found[k];
        if (!here->childnodes.empty()) {
            for (std::size_t j = 0; j < here->childnodes.size(); j++) {
                found.emplace_back(here->childnodes[j], VM * here->childtransforms[j]);
            }
        } else {
            for (std::size_t i = 0; i < here->models.size(); i++) {
                shader->modelview = VM * here->modeltransforms[i];
                shader->material = here->models[i]->material;
                shader->setUniforms();
                here->models[i]->geometry->draw();
            }
        }
    }
