    const float right = near * std::tan(glm::radians(fovy / 2.0f));
    const float top = right / aspect;
    const float depth = far - near;
    for (int i = 0; i < 4; ++i) {
        proj[i] = glm::vec4(0.0f);
    }
    proj[0].x = near / right;
    proj[1].y = near / top;
    proj[2].z = -(near + far) / depth;
    proj[2].w = -1.0f;
    proj[3].z = -2.0f * near * far / depth;
