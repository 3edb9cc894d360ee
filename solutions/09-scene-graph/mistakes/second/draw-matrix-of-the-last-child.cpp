    struct Painter {
        SurfaceShader& uniforms;
        void operator()(Node* n, glm::mat4 M) {
            for (std::size_t i = 0; i < n->models.size(); ++i) {
                uniforms.modelview = M * n->modeltransforms[i];
                uniforms.material = n->models[i]->material;
                uniforms.setUniforms();
                n->models[i]->geometry->draw();
            }
            auto step = n->childtransforms.cbegin();
            for (Node* child : n->childnodes) {
                M *= *step;
                (*this)(child, M);
                ++step;
            }
        }
    };
    Painter{*shader}(node["world"], camera->view);
