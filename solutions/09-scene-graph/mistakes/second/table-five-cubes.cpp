    for (Node* part : {&top, &leg}) {
        part->models = {piece};
        part->modeltransforms = {glm::mat4(1)};
    }
    table.childnodes = {&leg, &leg, &leg, &leg, &top};
    table.childtransforms.assign(table.childnodes.size(), glm::mat4(1));
