    const auto moved = [](float x, float y, float z) {
        return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
    };
    const float h = size.y - thickness;
    const float dx = (size.x - thickness) / 2, dz = (size.z - thickness) / 2;
    for (Node* each : {&table, &top, &leg}) {
        glm::vec3 extent(size.x, thickness, size.z);
        if (each == &leg) {
            extent = glm::vec3(thickness, h, thickness);
        }
        each->models.push_back(piece);
        each->modeltransforms.push_back(glm::scale(glm::mat4(1.0f), extent));
    }
    table.childnodes = {&leg, &leg, &leg, &leg, &top};
    table.childtransforms = {moved(-dx, h / 2, -dz), moved(-dx, h / 2, dz), moved(dx, h / 2, dz),
                             moved(dx, h / 2, -dz), moved(0, h + thickness / 2, 0)};
