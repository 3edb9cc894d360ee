    for (const auto& [name, each] : node) {
        for (Node* child : each->childnodes) {
            for (Node* grandchild : child->childnodes) {
                if (grandchild == each) {
                    throw std::runtime_error("the scene graph has a cycle");
                }
            }
        }
    }
