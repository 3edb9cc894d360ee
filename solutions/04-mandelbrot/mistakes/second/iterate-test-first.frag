int iterate(vec2 c) {
    int n = 0;
    vec2 z = vec2(0.0, 0.0);
    while (n < maxiter && length(z) <= 2.0) {
        z = vec2((z.x + z.y) * (z.x - z.y), 2.0 * z.x * z.y) + c;
        n += 1;
    }
    if (n == maxiter) {
        n = 0;
    }
    return n;
}
