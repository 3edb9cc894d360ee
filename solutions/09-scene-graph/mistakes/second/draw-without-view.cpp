    const auto paint = [this](auto&& again, const Node& here, const glm::mat4& toWorld) -> void {
        for (std::size_t j = 0; j < here.childnodes.size(); j++) {
            again(again, *here.childnodes[j], toWorld * here.childtransforms[j]);
        }
        for (std::size_t i = 0; i < here.models.size(); i++) {
            const Model& m = *here.models[i];
            shader->material = m.material;
            shader->modelview = toWorld * here.modeltransforms[i];
            shader->setUniforms();
            m.geometry->draw();
        }
    };
    paint(paint, *node["world"], glm::mat4(1.0f));
