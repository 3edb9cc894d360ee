    std::set<Node*> current = {node["world"]};
    std::function<void(Node*)> check = [&](Node* n) {
        if (!current.insert(n).second) {
            throw std::runtime_error("loop");
        }
        for (Node* child : n->childnodes) {
            check(child);
        }
        current.erase(n);
    };
    check(node["world"]);
