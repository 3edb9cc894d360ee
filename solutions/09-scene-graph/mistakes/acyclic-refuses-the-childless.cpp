    if (node["world"]->childnodes.empty()) {
        throw std::runtime_error("the scene graph is empty");
    }
    // Depth-first from the world: an edge back to a node of the current path closes a cycle. A node
    // whose descendants are all known to be fine is not looked through again, so that this takes one
    // step for each edge, however many paths there are.
    std::set<Node*> onPath = {node["world"]}, fine;
    std::stack<std::pair<Node*, std::size_t>> path;  // each node with its next edge
    path.push({node["world"], 0});
    while (!path.empty()) {
        Node* const current = path.top().first;
        if (path.top().second == current->childnodes.size()) {
            onPath.erase(current);
            fine.insert(current);
            path.pop();
            continue;
        }
        Node* const child = current->childnodes[path.top().second++];
        if (onPath.count(child) > 0) {
            throw std::runtime_error("the scene graph has a cycle");
        }
        if (fine.count(child) == 0) {
            onPath.insert(child);
            path.push({child, 0});
        }
    }
