    const float t = glm::radians(degrees) / 2;
    const float a = cos(t);
    const glm::vec3 w = float(sin(t)) * normalize(axis);
    const auto fill = [a, w](glm::mat3 M) {
        for (int j = 0; j < 3; ++j) {
            glm::vec3 e(0.0f);
            e[j] = 1.0f;
            M[j] = e + 2.0f * a * glm::cross(w, e) + 2.0f * glm::cross(w, glm::cross(w, e));
        }
    };
    glm::mat3 R(0.0f);
    fill(R);
    return R;
