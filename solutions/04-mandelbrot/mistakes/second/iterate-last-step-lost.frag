int iterate(vec2 c) {
    int result = 0, k = 0;
    vec2 z = c;
    while (k < maxiter - 1) {
        if (length(z) > 2.0) {
            result = k;
            break;
        }
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        k++;
    }
    return result;
}
