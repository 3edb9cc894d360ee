    const glm::mat4 one(1.0f);
    const glm::vec3 a(size.x / 2 - thickness / 2, 0, 0), b(0, 0, size.z / 2 - thickness / 2);
    for (const glm::vec3& place : {a + b, a - b, b - a, -a - b}) {
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(glm::translate(one, place));
    }
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(
        glm::scale(one, glm::vec3(thickness, size.y - thickness, thickness)));
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(one);
    top.models.push_back(piece);
    top.modeltransforms.push_back(glm::translate(one, size * glm::vec3(0, 1, 0)) *
                                  glm::translate(one, glm::vec3(0, -thickness / 2, 0)) *
                                  glm::scale(one, glm::vec3(size.x, thickness, size.z)));
