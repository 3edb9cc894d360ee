    enum Colour { white, grey, black };
    std::map<const Node*, Colour> colour;
    std::function<bool(const Node*)> isTree = [&](const Node* n) {
        std::printf("looking at %p with %zu children\n", static_cast<const void*>(n),
                    n->childnodes.size());
        colour[n] = grey;
        for (const Node* below : n->childnodes) {
            if (colour[below] == grey || (colour[below] == white && !isTree(below))) {
                return false;
            }
        }
        colour[n] = black;
        return true;
    };
    if (!isTree(node["world"])) {
        return;
    }
