    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), glm::radians(degrees), up);
    for (glm::vec3* point : {&eye, &target}) {
        *point = glm::vec3(turn * glm::vec4(*point, 1.0f));
    }
