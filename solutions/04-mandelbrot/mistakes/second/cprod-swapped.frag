vec2 cprod(vec2 z, vec2 w) {
    float re = dot(z, vec2(w.x, -w.y));
    float im = dot(z, w.yx);
    vec2 result;
    result[1] = re;
    result[0] = im;
    return result;
}
