    const glm::mat4 aroundUp = glm::rotate(glm::mat4(1.0f), glm::radians(degrees), up);
    const glm::vec4 arm(eye - target, 0.0f);
    eye = target + glm::vec3(aroundUp * arm);
    up = glm::vec3(aroundUp * glm::vec4(up, 0.0f));
