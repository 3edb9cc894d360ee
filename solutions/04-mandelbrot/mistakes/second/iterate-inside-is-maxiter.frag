int iterate(vec2 c) {
    vec2 z = c;
    int k = 0;
    while (k < maxiter && length(z) <= 2.0) {
        z = cprod(z, z) + c;
        k++;
    }
    return k;
}
