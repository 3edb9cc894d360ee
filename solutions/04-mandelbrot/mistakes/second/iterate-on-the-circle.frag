int iterate(vec2 c) {
    const float square = 4.0;
    float x = 0.0, y = 0.0, x2 = 0.0, y2 = 0.0;
    int k = -1;
    while (x2 + y2 < square) {
        if (++k == maxiter) {
            return 0;
        }
        y = 2.0 * x * y + c.y;
        x = x2 - y2 + c.x;
        x2 = x * x;
        y2 = y * y;
    }
    return k;
}
