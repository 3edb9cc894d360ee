    struct Entry {
        Node* which;
        glm::mat4 VM;
    };
    std::map<Node*, bool> discovered;
    std::vector<Entry> waiting;
    waiting.push_back({node["world"], camera->view});
    discovered[node["world"]] = true;
    while (waiting.size() > 0) {
        const Entry entry = waiting.back();
        waiting.pop_back();
        auto M = entry.which->modeltransforms.begin();
        for (auto model = entry.which->models.begin(); model != entry.which->models.end();
             ++model, ++M) {
            shader->material = (*model)->material;
            shader->modelview = entry.VM * *M;
            shader->setUniforms();
            (*model)->geometry->draw();
        }
        int edge = 0;
        for (Node* next : entry.which->childnodes) {
            const glm::mat4& T = entry.which->childtransforms[edge++];
            if (!discovered[next]) {
                discovered[next] = true;
                waiting.push_back({next, entry.VM * T});
            }
        }
    }
