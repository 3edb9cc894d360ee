    const glm::mat4 E(1.0f);
    const glm::vec3 legExtent(thickness, size.y - thickness, thickness);
    top.models.push_back(piece);
    top.childtransforms.push_back(glm::translate(E, {0, size.y - thickness / 2, 0}) *
                                  glm::scale(E, {size.x, thickness, size.z}));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(E);

    leg.models.push_back(piece);
    leg.modeltransforms.push_back(glm::scale(E, legExtent));
    const glm::vec3 far = (size - legExtent) / 2.0f;
    for (int k = 0; k < 4; ++k) {
        const glm::vec3 sign(k < 2 ? 1 : -1, 1, k % 2 ? 1 : -1);
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(
            glm::translate(E, sign * glm::vec3(far.x, legExtent.y / 2, far.z)));
    }
