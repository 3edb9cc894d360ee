    struct Walk {
        SurfaceShader* shader;
        void visit(const Node* current, const glm::mat4& matrix, int depth) {
            for (std::size_t i = 0; i < current->models.size(); ++i) {
                shader->modelview = matrix * current->modeltransforms[i];
                shader->material = current->models[i]->material;
                shader->setUniforms();
                current->models[i]->geometry->draw();
            }
            for (std::size_t j = 0; depth < 100 && j < current->childnodes.size(); ++j) {
                visit(current->childnodes[j], matrix * current->childtransforms[j], depth + 1);
            }
        }
    };
    Walk{shader}.visit(node["world"], camera->view, 0);
