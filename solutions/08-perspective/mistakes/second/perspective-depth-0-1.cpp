    const float a = far / (near - far);
    const float cot = 1.0f / std::tan(glm::radians(fovy) * 0.5f);
    const glm::vec4 rows[4] = {glm::vec4(cot / aspect, 0.0f, 0.0f, 0.0f),
                               glm::vec4(0.0f, cot, 0.0f, 0.0f),
                               glm::vec4(0.0f, 0.0f, a, near * a),
                               glm::vec4(0.0f, 0.0f, -1.0f, 0.0f)};
    proj = glm::transpose(glm::mat4(rows[0], rows[1], rows[2], rows[3]));
