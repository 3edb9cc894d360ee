    for (const auto& entry : node) {
        const Node& each = *entry.second;
        if (each.childnodes.size() != each.childtransforms.size()) {
            throw std::logic_error(entry.first + " has a child without a transform");
        }
    }
