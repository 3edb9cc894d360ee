    const glm::mat3 R = rotation(degrees, up);
    eye = R * eye;
    target = R * target;
