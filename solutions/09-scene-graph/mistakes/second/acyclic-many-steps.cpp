    std::size_t left = 3 * node.size();
    std::function<void(const Node*)> count = [&](const Node* here) {
        if (left == 0) {
            throw std::runtime_error("this scene never ends");
        }
        --left;
        for (const Node* below : here->childnodes) {
            count(below);
        }
    };
    count(node["world"]);
