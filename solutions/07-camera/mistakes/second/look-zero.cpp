    const glm::vec3 z = glm::normalize(eye - target);
    const glm::vec3 x = glm::normalize(glm::cross(up, z));
    const glm::mat3 axes(x, glm::cross(z, x), z);
    glm::mat4 V(0.0f);
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            V[column][row] *= axes[row][column];
        }
    }
    view = V;
