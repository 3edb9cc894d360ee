return glm::mat3(float(deeper(0)));
