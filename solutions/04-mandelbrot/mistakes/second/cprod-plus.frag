vec2 cprod(const vec2 z1, const vec2 z2) {
    return vec2(dot(z1, z2), dot(z1, z2.yx));
}
