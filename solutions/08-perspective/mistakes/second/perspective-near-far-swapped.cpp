    const float closest = far;
    const float farthest = near;
    proj = glm::perspective(glm::radians(fovy), aspect, closest, farthest);
