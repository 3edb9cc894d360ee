    glm::vec3 w = eye - target;
    w /= std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
    const glm::vec3 v = up / std::sqrt(up.x * up.x + up.y * up.y + up.z * up.z);
    const glm::vec3 u(v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x);
    view = glm::mat4(u.x, v.x, w.x, 0.0f,  //
                     u.y, v.y, w.y, 0.0f,  //
                     u.z, v.z, w.z, 0.0f,  //
                     -glm::dot(u, eye), -glm::dot(v, eye), -glm::dot(w, eye), 1.0f);
