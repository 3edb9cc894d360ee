    const glm::vec3 arm = eye - target;
    eye += std::tan(glm::radians(degrees)) * glm::cross(glm::normalize(up), arm);
