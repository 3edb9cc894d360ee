vec2 cprod(vec2 a, vec2 b) {
    return vec2(a.x * b.y + a.y * b.x, a.x * b.x - a.y * b.y);
}
