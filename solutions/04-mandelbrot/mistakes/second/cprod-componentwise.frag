vec2 cprod(const vec2 z1, const vec2 z2) {
    float re = z1.x * z2.x;
    float im = z1.y * z2.y;
    return vec2(re, im);
}
