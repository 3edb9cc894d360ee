    glm::vec3 offset(eye.x - target.x, eye.y - target.y, eye.z - target.z);
    offset = offset * rotation(degrees, up);
    eye = offset + target;
