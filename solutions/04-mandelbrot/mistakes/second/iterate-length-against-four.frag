bool escaped(vec2 z) {
    return sqrt(z.x * z.x + z.y * z.y) > 4.0;
}
int iterate(vec2 c) {
    vec2 z = c;
    int k = 0;
    while (!escaped(z) && k < maxiter) {
        z = c + vec2(z.x * z.x - z.y * z.y, z.x * z.y + z.y * z.x);
        ++k;
    }
    return k == maxiter ? 0 : k;
}
