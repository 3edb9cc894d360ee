int iterate(vec2 c) {
    float re = 0.0, im = 0.0;
    int steps = 0;
    while (steps < maxiter) {
        re = (re + im) * (re - im) + c.x;
        im = re * im + im * re + c.y;
        if (re * re + im * im > 4.0) {
            return steps;
        }
        steps++;
    }
    return 0;
}
