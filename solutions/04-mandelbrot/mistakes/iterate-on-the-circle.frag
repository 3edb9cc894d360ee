int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; ++k) {
        z = cprod(z, z) + c;
        if (length(z) >= 2.0) {
            return k;
        }
    }
    return 0;
}
