void multiply(vec2 z, vec2 w) {
    z = vec2(z.x * w.x - z.y * w.y, z.y * w.x + z.x * w.y);
}
vec2 cprod(const vec2 z1, const vec2 z2) {
    vec2 z = z1;
    multiply(z, z2);
    return z;
}
