vec2 cprod(const vec2 z1, const vec2 z2) {
    float re = (z1.x + z1.y) * (z1.x - z1.y);
    float im = z1.x * z1.y + z1.y * z1.x;
    return vec2(re, im);
}
