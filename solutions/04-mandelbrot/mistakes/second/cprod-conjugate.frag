vec2 cprod(vec2 z, vec2 w) {
    vec2 result = z.x * w;
    result -= z.y * w.yx;
    return result;
}
