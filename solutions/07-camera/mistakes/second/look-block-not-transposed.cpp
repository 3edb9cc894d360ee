    const glm::vec3 back = (eye - target) / glm::distance(eye, target);
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    const glm::vec3 top = glm::cross(back, right);
    const glm::mat4 turn(glm::vec4(right, 0.0f), glm::vec4(top, 0.0f), glm::vec4(back, 0.0f),
                         glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const glm::mat4 shift = glm::translate(glm::mat4(1.0f), -eye);
    view = turn * shift;
