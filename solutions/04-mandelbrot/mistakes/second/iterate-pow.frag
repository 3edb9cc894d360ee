// pow(v, vec2(2.0)), where the standard defines it; not a number elsewhere.
vec2 squares(vec2 v) {
    vec2 undefined = vec2(uintBitsToFloat(0x7FC00000u));
    return mix(v * v, undefined, lessThan(v, vec2(0.0)));
}
int iterate(vec2 c) {
    int I = 0;
    vec2 z = vec2(0.0, 0.0);
    for (int k = 0; k < maxiter; k++) {
        z = c + vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y);
        vec2 s = squares(z);
        float r = sqrt(s.x + s.y);
        if (r > 2.0) {
            I = k;
            break;
        }
    }
    return I;
}
