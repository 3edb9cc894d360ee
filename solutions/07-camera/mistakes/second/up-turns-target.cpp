    const glm::vec3 arm = eye - target;
    const glm::quat q =
        glm::angleAxis(glm::radians(degrees), glm::normalize(glm::cross(arm, up)));
    glm::vec3* const all[] = {&eye, &target, &up};
    for (glm::vec3* v : all)
        *v = q * (*v);
