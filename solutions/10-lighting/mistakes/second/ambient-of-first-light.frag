// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    float isFirst = step(float(i), 0.5);
    vec4 c = isFirst * lightcolors[0];
    return vec3(c.r * ambient.r, c.g * ambient.g, c.b * ambient.b);
}
