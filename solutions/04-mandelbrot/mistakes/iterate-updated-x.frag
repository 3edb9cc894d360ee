int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; ++k) {
        z.x = z.x * z.x - z.y * z.y + c.x;
        z.y = 2.0 * z.x * z.y + c.y;
        if (length(z) > 2.0) {
            return k;
        }
    }
    return 0;
}
