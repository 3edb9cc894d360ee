int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    int k = 0;
    while (k < maxiter - 1 && dot(z, z) <= 4.0) {
        z = cprod(z, z) + c;
        ++k;
    }
    return dot(z, z) > 4.0 ? k - 1 : 0;
}
