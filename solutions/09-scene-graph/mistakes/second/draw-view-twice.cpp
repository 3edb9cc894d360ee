    const glm::mat4 V = shader->view;
    std::vector<Node*> level = {node["world"]};
    std::vector<glm::mat4> frames = {camera->view};
    while (!level.empty()) {
        std::vector<Node*> below;
        std::vector<glm::mat4> belowFrames;
        for (std::size_t n = 0; n < level.size(); n++) {
            for (std::size_t i = 0; i < level[n]->models.size(); i++) {
                const glm::mat4 toWorld = frames[n] * level[n]->modeltransforms[i];
                shader->modelview = V * toWorld;
                shader->material = level[n]->models[i]->material;
                shader->setUniforms();
                level[n]->models[i]->geometry->draw();
            }
            for (std::size_t j = 0; j < level[n]->childnodes.size(); j++) {
                below.push_back(level[n]->childnodes[j]);
                belowFrames.push_back(frames[n] * level[n]->childtransforms[j]);
            }
        }
        level.swap(below);
        frames.swap(belowFrames);
    }
