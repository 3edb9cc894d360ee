    std::set<std::pair<Node*, Node*>> arrows;
    for (const auto& entry : node) {
        for (Node* to : entry.second->childnodes) {
            arrows.emplace(entry.second, to);
        }
    }
    for (const auto& arrow : arrows) {
        if (arrows.count({arrow.second, arrow.first}) != 0) {
            throw std::domain_error("two nodes contain each other");
        }
    }
