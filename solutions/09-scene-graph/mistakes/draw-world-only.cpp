    const Node* world = node["world"];
    for (std::size_t i = 0; i < world->models.size(); ++i) {
        shader->modelview = camera->view * world->modeltransforms[i];
        shader->material = world->models[i]->material;
        shader->setUniforms();
        world->models[i]->geometry->draw();
    }
