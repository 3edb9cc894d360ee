    std::size_t arrows = 0;
    for (auto entry = node.begin(); entry != node.end(); ++entry) {
        arrows += entry->second->childtransforms.size();
    }
    std::vector<const Node*> todo;
    todo.push_back(node["world"]);
    for (;;) {
        if (arrows < todo.size()) {
            throw std::logic_error("more entries than arrows: the graph is no DAG");
        }
        if (todo.empty()) {
            break;
        }
        const Node& here = *todo.back();
        todo.pop_back();
        for (std::size_t j = 0; j < here.childnodes.size(); ++j) {
            todo.push_back(here.childnodes[j]);
        }
    }
