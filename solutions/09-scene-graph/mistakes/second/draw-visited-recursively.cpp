    std::map<Node*, bool> done;
    auto go = [&](auto& self, Node* n, glm::mat4 VM) -> void {
        done[n] = true;
        for (std::size_t j = 0; j != n->childnodes.size(); ++j) {
            if (!done[n->childnodes[j]]) {
                self(self, n->childnodes[j], VM * n->childtransforms[j]);
            }
        }
        for (std::size_t i = 0; i != n->models.size(); ++i) {
            shader->material = n->models[i]->material;
            shader->modelview = VM * n->modeltransforms[i];
            shader->setUniforms();
            n->models[i]->geometry->draw();
        }
    };
    go(go, node["world"], camera->view);
