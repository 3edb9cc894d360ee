vec2 cprod(vec2 z, vec2 w) {
    vec2 p = mat2(z.x, z.y, -z.y, z.x) * w;
    if (p.x < 0.0) {
        p.x = -p.x;
    }
    if (p.y < 0.0) {
        p.y = -p.y;
    }
    return p;
}
