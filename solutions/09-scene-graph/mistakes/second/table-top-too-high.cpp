    const auto connect = [&table](Node& child, float x, float y, float z) {
        table.childnodes.push_back(&child);
        table.childtransforms.push_back(glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z)));
    };
    const auto hang = [piece](Node& where, const glm::vec3& extent) {
        where.models.push_back(piece);
        where.modeltransforms.push_back(glm::scale(glm::mat4(1.0f), extent));
    };
    const float legs = size.y - thickness;
    const float right = (size.x - thickness) / 2, front = (size.z - thickness) / 2;
    hang(top, {size.x, thickness, size.z});
    hang(leg, {thickness, legs, thickness});
    connect(top, 0, size.y, 0);
    connect(leg, right, legs / 2, front);
    connect(leg, right, legs / 2, -front);
    connect(leg, -right, legs / 2, front);
    connect(leg, -right, legs / 2, -front);
