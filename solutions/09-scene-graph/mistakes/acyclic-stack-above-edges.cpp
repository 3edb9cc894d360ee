    std::stack<Node*> pending;
    pending.push(node["world"]);
    std::size_t edges = 0;
    for (const auto& [name, each] : node) {
        edges += each->childnodes.size();
    }
    while (!pending.empty()) {
        if (pending.size() > edges) {
            throw std::runtime_error("the scene graph has a cycle");
        }
        Node* const current = pending.top();
        pending.pop();
        for (Node* child : current->childnodes) {
            pending.push(child);
        }
    }
