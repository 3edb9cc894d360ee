int iterate(vec2 c) {
    vec2 z = c;
    for (int k = 0; k < maxiter; ++k) {
        z = cprod(z, z);
        if (dot(z, z) > 4.0) {
            return k;
        }
    }
    return 0;
}
