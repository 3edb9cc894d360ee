int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    int k = 0;
    for (; k < maxiter; k++) {
        z = vec2(dot(z, vec2(z.x, -z.y)), 2.0 * z.x * z.y) + c;
        if (distance(z, vec2(0.0)) > 2.0) {
            break;
        }
    }
    if (k >= maxiter - 1) {
        return 0;
    }
    return k;
}
