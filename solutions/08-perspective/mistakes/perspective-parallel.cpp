    proj = glm::mat4(1.0f);
    proj[0][0] = 1.0f / aspect;
    proj[2][2] = -0.1f;
