    const float top = std::tan(glm::radians(fovy) / 2.0f);
    const float right = top * aspect;
    const float range = near - far;
    proj = glm::mat4(glm::vec4(1.0f / right, 0.0f, 0.0f, 0.0f),
                     glm::vec4(0.0f, 1.0f / top, 0.0f, 0.0f),
                     glm::vec4(0.0f, 0.0f, (near + far) / range, 1.0f),
                     glm::vec4(0.0f, 0.0f, 2.0f * near * far / range, 0.0f));
