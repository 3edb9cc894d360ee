    glm::mat3 product;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            product[column][row] = row == column ? 1.0f : u.x * 0.0f;
    return product;
