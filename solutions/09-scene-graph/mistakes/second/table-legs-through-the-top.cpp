    const glm::vec3 half = 0.5f * size;
    const glm::vec3 inset(0.5f * thickness);

    leg.models.assign(1, piece);
    leg.modeltransforms.assign(
        1, glm::scale(glm::mat4(1.0f), glm::vec3(thickness, size.y, thickness)));
    for (int sx = -1; sx <= 1; sx += 2) {
        for (int sz = -1; sz <= 1; sz += 2) {
            glm::mat4 T(1.0f);
            T[3] = glm::vec4(sx * (half.x - inset.x), half.y, sz * (half.z - inset.z), 1.0f);
            table.childnodes.push_back(&leg);
            table.childtransforms.push_back(T);
        }
    }

    top.models.assign(1, piece);
    top.modeltransforms.assign(1, glm::mat4(1.0f));
    glm::mat4 board = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, size.y - inset.y, 0.0f));
    board = glm::scale(board, glm::vec3(size.x, thickness, size.z));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(board);
