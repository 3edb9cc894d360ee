int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; ++k) {
        if (dot(z, z) > 4.0) {
            return k;
        }
        z = cprod(z, z) + c;
    }
    return 0;
}
