    top.models.push_back(piece);
    top.modeltransforms.push_back(glm::scale(glm::mat4(1.0f), glm::vec3(1.7f, 0.12f, 0.9f)));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(
        glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 1.04f, 0.0f)));

    leg.models.push_back(piece);
    leg.modeltransforms.push_back(glm::scale(glm::mat4(1.0f), glm::vec3(0.12f, 0.98f, 0.12f)));
    const glm::vec3 feet[4] = {{0.79f, 0.49f, 0.39f},
                               {0.79f, 0.49f, -0.39f},
                               {-0.79f, 0.49f, 0.39f},
                               {-0.79f, 0.49f, -0.39f}};
    for (int k = 0; k < 4; k++) {
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(glm::translate(glm::mat4(1.0f), feet[k]));
    }
