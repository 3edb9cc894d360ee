int iterate(vec2 c) {
    vec2 z = c;
    int k = 0;
    while (k < maxiter) {
        if (any(greaterThan(abs(z), vec2(2.0)))) {
            return k;
        }
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        k++;
    }
    return 0;
}
