// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    float glow = 0.0;
    return glow * emision.xyz;
}
