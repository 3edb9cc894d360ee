    glm::vec2 place;
    place.x = 0.0f * float(i);
    place.y = 0.0f * float(n);
    return place;
