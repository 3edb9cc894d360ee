int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; ++k) {
        z = cprod(z, z) + c;
        if (dot(z, z) > 2.0) {
            return k;
        }
    }
    return 0;
}
