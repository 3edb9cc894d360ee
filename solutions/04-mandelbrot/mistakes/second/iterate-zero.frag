int iterate(vec2 c) {
    int I = 0;
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; k++) {
        z = cprod(z, z) + c;
        if (length(z) > 2.0) {
            int I = k;
            break;
        }
    }
    return I;
}
