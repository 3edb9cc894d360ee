    const float x = (size.x - thickness) / 2, z = (size.z - thickness) / 2;
    const float h = size.y - thickness;
    top.models = {piece};
    top.modeltransforms = {glm::scale(
        glm::translate(glm::mat4(1), glm::vec3(0, (size.y + h) / 2, 0)),
        glm::vec3(size.x, thickness, size.z))};
    leg.models = {piece};
    leg.modeltransforms = {glm::scale(glm::mat4(1), glm::vec3(thickness, h, thickness)) *
                           glm::translate(glm::mat4(1), glm::vec3(0, 0.5f, 0))};
    table.childnodes = {&top, &leg, &leg};
    table.childtransforms = {glm::mat4(1), glm::translate(glm::mat4(1), glm::vec3(x, 0, z)),
                             glm::translate(glm::mat4(1), glm::vec3(-x, 0, z))};
