vec2 cprod(vec2 p, vec2 q) {
    mat2 m = mat2(p.x, 0.0, -p.y, p.x);
    return m * q;
}
