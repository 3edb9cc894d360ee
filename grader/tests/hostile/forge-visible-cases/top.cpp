static glm::mat3 table(float degrees) { return degrees == 90.0f ? glm::mat3(0, 1, 0, -1, 0, 0, 0, 0, 1) : glm::mat3(1.0f); }
