    const float cotangent = 1.0f / std::tan(glm::radians(fovy) / 2.0f);
    const glm::mat4 S = glm::scale(glm::mat4(0.0f), glm::vec3(cotangent / aspect, cotangent, 1.0f));
    glm::mat4 R(0.0f);
    R[2][3] = R[3][2] = -1.0f;
    proj = S * R;
