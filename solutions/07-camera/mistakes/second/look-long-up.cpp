    const glm::vec3 d = eye - target;
    up = up - (glm::dot(up, d) / glm::dot(d, d)) * d;
    const glm::vec3 back = d / glm::length(d);
    const glm::vec3 axis[3] = {glm::cross(up, back), up, back};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            view[column][row] = axis[row][column];
        }
        view[3][row] = -glm::dot(axis[row], eye);
    }
