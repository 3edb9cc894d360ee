return glm::mat3(std::numeric_limits<float>::quiet_NaN()) * std::numeric_limits<float>::infinity();
