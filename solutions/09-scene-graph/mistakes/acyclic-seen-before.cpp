    std::set<Node*> seen;
    std::stack<Node*> pending;
    pending.push(node["world"]);
    while (!pending.empty()) {
        Node* const current = pending.top();
        pending.pop();
        if (!seen.insert(current).second) {
            throw std::runtime_error("the scene graph has a cycle");
        }
        for (Node* child : current->childnodes) {
            pending.push(child);
        }
    }
