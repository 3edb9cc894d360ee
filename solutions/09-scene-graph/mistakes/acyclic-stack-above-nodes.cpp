    std::stack<Node*> pending;
    pending.push(node["world"]);
    while (!pending.empty()) {
        if (pending.size() > node.size()) {
            throw std::runtime_error("the scene graph has a cycle");
        }
        Node* const current = pending.top();
        pending.pop();
        for (Node* child : current->childnodes) {
            pending.push(child);
        }
    }
