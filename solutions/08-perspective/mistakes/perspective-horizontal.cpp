    const float t = std::tan(0.5f * glm::radians(fovy));
    proj = glm::mat4(0.0f);
    proj[0][0] = 1.0f / t;
    proj[1][1] = aspect / t;
    proj[2][2] = -(far + near) / (far - near);
    proj[2][3] = -1.0f;
    proj[3][2] = -2.0f * far * near / (far - near);
