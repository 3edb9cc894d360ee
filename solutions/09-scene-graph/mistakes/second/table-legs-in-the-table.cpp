    const float h = size.y - thickness;
    std::vector<glm::vec3> middles;
    for (float x = -1; x < 2; x += 2) {
        for (float z = -1; z < 2; z += 2) {
            middles.emplace_back(x * (size.x - thickness) / 2, h / 2,
                                 z * (size.z - thickness) / 2);
        }
    }
    table.models.assign(middles.size(), piece);
    for (const glm::vec3& middle : middles) {
        glm::mat4 M = glm::scale(glm::mat4(1.0f), glm::vec3(thickness, h, thickness));
        M[3] = glm::vec4(middle, 1.0f);
        table.modeltransforms.push_back(M);
    }
    table.childnodes = {&top};
    table.childtransforms = {glm::mat4(1.0f)};
    top.models = {piece};
    glm::mat4 M = glm::scale(glm::mat4(1.0f), glm::vec3(size.x, thickness, size.z));
    M[3].y = h + thickness / 2;
    top.modeltransforms = {M};
