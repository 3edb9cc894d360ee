vec2 cprod(vec2 a, vec2 b) {
    return vec2(0.0);
}
