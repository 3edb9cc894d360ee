    for (const auto& [name, each] : node) {
        for (Node* child : each->childnodes) {
            if (child == node["world"]) {
                throw std::runtime_error("the scene graph has a cycle");
            }
        }
    }
