    const auto box = [](glm::vec3 low, glm::vec3 high) {
        glm::mat4 M(1.0f);
        M = glm::translate(M, (low + high) / 2.0f);
        M = glm::scale(M, high - low);
        return M;
    };
    const float w = size.x / 2, d = size.z / 2, t = thickness / 2;
    const float under = size.y - thickness;
    top.models.push_back(piece);
    top.modeltransforms.push_back(box({-w, under, -d}, {w, size.y, d}));
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(box({-t, 0, -t}, {t, under, t}));

    table.childnodes = {&top, &leg, &leg, &leg, &leg};
    table.childtransforms.push_back(glm::mat4(1.0f));
    for (int k = 0; k < 4; k++) {
        table.childtransforms.push_back(glm::translate(
            glm::mat4(1.0f), glm::vec3(k % 2 == 0 ? -w : w, 0.0f, k < 2 ? -d : d)));
    }
