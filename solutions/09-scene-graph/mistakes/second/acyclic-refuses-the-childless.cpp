    const Node* const root = node["world"];
    if (root->childnodes.size() < 1) {
        throw std::length_error("nothing hangs in the world");
    }
    std::function<void(const Node*, std::size_t)> measure = [&](const Node* n, std::size_t depth) {
        if (depth > node.size()) {
            throw std::length_error("a path is longer than the list of nodes");
        }
        for (auto below = n->childnodes.begin(); below != n->childnodes.end(); ++below) {
            measure(*below, depth + 1);
        }
    };
    measure(root, 1);
