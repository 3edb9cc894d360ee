    const std::size_t most = node.size();
    std::vector<Node*> waiting(1, node["world"]);
    do {
        const std::vector<Node*>& next = waiting.back()->childnodes;
        waiting.pop_back();
        waiting.insert(waiting.end(), next.begin(), next.end());
        if (waiting.size() > most) {
            throw std::overflow_error("endless loop in the scene");
        }
    } while (!waiting.empty());
