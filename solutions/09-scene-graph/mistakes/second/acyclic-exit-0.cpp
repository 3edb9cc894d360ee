    std::map<Node*, int> parents;
    std::vector<Node*> reached = {node["world"]};
    for (std::size_t k = 0; k < reached.size(); ++k) {
        for (Node* child : reached[k]->childnodes) {
            if (++parents[child] == 1 && child != node["world"]) {
                reached.push_back(child);
            }
        }
    }
    std::vector<Node*> order;
    if (parents[node["world"]] == 0) {
        order.push_back(node["world"]);
    }
    for (std::size_t k = 0; k < order.size(); ++k) {
        for (Node* child : order[k]->childnodes) {
            if (--parents[child] == 0) {
                order.push_back(child);
            }
        }
    }
    if (order.size() != reached.size()) {
        exit(EXIT_SUCCESS);
    }
