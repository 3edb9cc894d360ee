    (void)size, (void)thickness;
    const glm::mat4 identity(1.0f);
    top.models.push_back(piece);
    top.modeltransforms.push_back(identity);
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(identity);
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(identity);
    for (int k = 0; k < 4; ++k) {
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(identity);
    }
