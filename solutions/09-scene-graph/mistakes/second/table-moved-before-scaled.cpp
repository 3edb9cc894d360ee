    const glm::mat4 I(1.0f);
    const float h = size.y - thickness;
    const glm::vec3 reach = (size - thickness) / 2.0f;

    leg.models = {piece};
    leg.modeltransforms = {glm::scale(I, glm::vec3(thickness, h, thickness)) *
                           glm::translate(I, glm::vec3(0, h / 2, 0))};
    const glm::vec3 corners[] = {{-reach.x, 0, -reach.z},
                                 {reach.x, 0, -reach.z},
                                 {reach.x, 0, reach.z},
                                 {-reach.x, 0, reach.z}};
    for (const glm::vec3& corner : corners) {
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(glm::translate(I, corner));
    }

    top.models = {piece};
    top.modeltransforms = {glm::translate(I, glm::vec3(0, h + thickness / 2, 0)) *
                           glm::scale(I, glm::vec3(size.x, thickness, size.z))};
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(I);
