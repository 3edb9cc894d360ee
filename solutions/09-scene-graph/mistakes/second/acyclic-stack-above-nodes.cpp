    const std::size_t most = node.size();
    std::vector<Node*> todo(1, node["world"]);
    do {
        const std::vector<Node*>& next = todo.back()->childnodes;
        todo.pop_back();
        todo.insert(todo.end(), next.begin(), next.end());
        if (todo.size() > most) {
            throw std::overflow_error("endless loop in the scene");
        }
    } while (!todo.empty());
