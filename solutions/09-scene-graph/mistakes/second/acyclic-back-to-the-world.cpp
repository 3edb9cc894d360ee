    Node* const root = node.at("world");
    std::set<Node*> below;
    for (auto entry = node.begin(); entry != node.end(); ++entry) {
        below.insert(entry->second->childnodes.begin(), entry->second->childnodes.end());
    }
    if (below.find(root) != below.end()) {
        throw std::invalid_argument("the world is part of itself");
    }
