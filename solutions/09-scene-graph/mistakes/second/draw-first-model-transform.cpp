    std::deque<Node*> who = {node["world"]};
    std::deque<glm::mat4> where = {glm::mat4(1.0f)};
    while (!who.empty()) {
        Node& here = *who.front();
        const glm::mat4 toWorld = where.front();
        who.pop_front();
        where.pop_front();
        for (const Model* m : here.models) {
            shader->modelview = camera->view * toWorld * *here.modeltransforms.begin();
            shader->material = m->material;
            shader->setUniforms();
            m->geometry->draw();
        }
        who.insert(who.end(), here.childnodes.begin(), here.childnodes.end());
        for (const glm::mat4& T : here.childtransforms) {
            where.push_back(toWorld * T);
        }
    }
