int iterate(vec2 c) {
    int I = 0;
    for (int k = 0; k < maxiter; k++) {
        c += vec2(c.x * c.x - c.y * c.y, 2.0 * c.x * c.y);
        if (length(c) > 2.0) {
            I = k;
            break;
        }
    }
    return I;
}
