int iterate(vec2 c) {
    float x = 0.0, y = 0.0;
    int steps = 0;
    do {
        float xx = x * x - y * y + c.x;
        y = 2.0 * x * y + c.y;
        x = xx;
        steps++;
    } while (steps < maxiter && x * x + y * y <= 4.0);
    return x * x + y * y > 4.0 ? steps : 0;
}
