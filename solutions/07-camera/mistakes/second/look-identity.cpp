    const glm::vec3 back = glm::normalize(eye - target);
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    const glm::vec3 top = glm::cross(back, right);
    glm::mat4 view(1.0f);
    for (int i = 0; i < 3; ++i) {
        view[i] = glm::vec4(right[i], top[i], back[i], 0.0f);
    }
    view = glm::translate(view, -eye);
