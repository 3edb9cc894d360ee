// What pow(x, 2.0) is on a machine that takes the standard at its word.
float square(float x) {
    return x < 0.0 ? uintBitsToFloat(0x7FC00000u) : x * x;  // not a number
}
int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; ++k) {
        z = cprod(z, z) + c;
        if (square(z.x) + square(z.y) > 4.0) {
            return k;
        }
    }
    return 0;
}
