    struct Drawer {
        SurfaceShader* program;
        void one(const Model* model, const glm::mat4& modelview) const {
            program->material = model->material;
            program->modelview = modelview;
            model->geometry->draw();
            program->setUniforms();
        }
        void all(const Node* n, const glm::mat4& VM) const {
            for (std::size_t i = 0; i < n->models.size(); i++) {
                one(n->models[i], VM * n->modeltransforms[i]);
            }
            for (std::size_t j = n->childnodes.size(); j > 0; j--) {
                all(n->childnodes[j - 1], VM * n->childtransforms[j - 1]);
            }
        }
    };
    const Drawer drawer{shader};
    drawer.all(node["world"], camera->view);
