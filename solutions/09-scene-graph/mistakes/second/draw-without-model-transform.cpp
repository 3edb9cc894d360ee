    struct Place {
        Node* where;
        glm::mat4 toCamera;
    };
    std::vector<Place> places{{node["world"], camera->view}};
    for (std::size_t next = 0; next < places.size(); ++next) {
        const Place here = places[next];
        shader->modelview = here.toCamera;
        for (const Model* m : here.where->models) {
            shader->material = m->material;
            shader->setUniforms();
            m->geometry->draw();
        }
        std::size_t j = 0;
        for (Node* below : here.where->childnodes) {
            places.push_back({below, here.toCamera * here.where->childtransforms[j++]});
        }
    }
