    std::vector<Node*> met = {node["world"]};
    for (std::size_t k = 0; k < met.size(); ++k) {
        for (std::size_t j = 0; j < met[k]->childnodes.size(); ++j) {
            Node* const next = met[k]->childnodes[j];
            if (std::find(met.begin(), met.end(), next) != met.end()) {
                throw std::runtime_error("a node comes twice");
            }
            met.push_back(next);
        }
    }
