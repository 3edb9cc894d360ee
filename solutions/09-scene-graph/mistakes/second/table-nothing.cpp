    std::vector<glm::mat4> pieces;
    const float middle = (size.y - thickness) / 2;
    for (int corner = 0; corner < 4; ++corner) {
        const float x = (size.x - thickness) / (corner % 2 ? 2 : -2);
        const float z = (size.z - thickness) / (corner / 2 ? 2 : -2);
        pieces.push_back(glm::translate(glm::mat4(1.0f), glm::vec3(x, middle, z)) *
                         glm::scale(glm::mat4(1.0f), glm::vec3(thickness, 2 * middle, thickness)));
    }
    pieces.push_back(glm::translate(glm::mat4(1.0f), glm::vec3(0, size.y - thickness / 2, 0)) *
                     glm::scale(glm::mat4(1.0f), glm::vec3(size.x, thickness, size.z)));
