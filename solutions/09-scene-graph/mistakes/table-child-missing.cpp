    const glm::mat4 identity(1.0f);
    const float legHeight = size.y - thickness;

    top.models.push_back(piece);
    top.modeltransforms.push_back(glm::scale(identity, glm::vec3(size.x, thickness, size.z)));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(
        glm::translate(identity, glm::vec3(0.0f, size.y - 0.5f * thickness, 0.0f)));

    // A leg stands on the origin of its node.
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(
        glm::scale(glm::translate(identity, glm::vec3(0.0f, 0.5f * legHeight, 0.0f)),
                   glm::vec3(thickness, legHeight, thickness)));
    for (const float x : {-0.5f, 0.5f}) {
        for (const float z : {-0.5f, 0.5f}) {
            table.childnodes.push_back(&leg);
            table.childtransforms.push_back(glm::translate(
                identity, glm::vec3(x * (size.x - thickness), 0.0f, z * (size.z - thickness))));
        }
    }
    table.childnodes.pop_back();
