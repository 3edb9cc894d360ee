    glm::mat4 P(1.0f);
    P[0][0] = 2.0f / height;
    P[1][1] = 2.0f * aspect / height;
    P[2][2] = -2.0f / (f - n);
    P[3][2] = -(f + n) / (f - n);
    return P;
