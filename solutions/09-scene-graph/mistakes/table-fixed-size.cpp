    // The numbers of the picture.
    (void)size, (void)thickness;
    const glm::vec3 own(1.7f, 1.1f, 0.9f);
    const float thick = 0.12f;
    const glm::mat4 identity(1.0f);
    const float legHeight = own.y - thick;

    top.models.push_back(piece);
    top.modeltransforms.push_back(glm::scale(identity, glm::vec3(own.x, thick, own.z)));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(
        glm::translate(identity, glm::vec3(0.0f, own.y - 0.5f * thick, 0.0f)));

    // A leg stands on the origin of its node.
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(
        glm::scale(glm::translate(identity, glm::vec3(0.0f, 0.5f * legHeight, 0.0f)),
                   glm::vec3(thick, legHeight, thick)));
    for (const float x : {-0.5f, 0.5f}) {
        for (const float z : {-0.5f, 0.5f}) {
            table.childnodes.push_back(&leg);
            table.childtransforms.push_back(glm::translate(
                identity, glm::vec3(x * (own.x - thick), 0.0f, z * (own.z - thick))));
        }
    }
