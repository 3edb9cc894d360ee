    eye = target + rotation(degrees, glm::vec3(0.0f, 1.0f, 0.0f)) * (eye - target);
