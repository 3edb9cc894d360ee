    const float depth = size.x, height = size.y, width = size.z;
    glm::mat4 T = glm::translate(glm::mat4(1.0f), glm::vec3(0, height - thickness / 2, 0));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(T);
    top.models.push_back(piece);
    top.modeltransforms.push_back(glm::scale(glm::mat4(1.0f), glm::vec3(width, thickness, depth)));

    glm::mat4 S = glm::scale(glm::mat4(1.0f), glm::vec3(thickness, height - thickness, thickness));
    S[3][1] = (height - thickness) / 2;
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(S);
    for (int corner = 0; corner < 4; corner++) {
        glm::vec3 where((width - thickness) / 2, 0, (depth - thickness) / 2);
        where.x *= corner & 1 ? 1.0f : -1.0f;
        where.z *= corner & 2 ? 1.0f : -1.0f;
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(glm::translate(glm::mat4(1.0f), where));
    }
