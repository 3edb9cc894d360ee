vec2 cprod(vec2 a, vec2 b) {
    return vec2(a.x * a.x - a.y * a.y, 2.0 * a.x * a.y);
}
