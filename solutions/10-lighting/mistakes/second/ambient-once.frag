// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    if (i > 0) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec4 base = ambient;
    return base.xyz;
}
