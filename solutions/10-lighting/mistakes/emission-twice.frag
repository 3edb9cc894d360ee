// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    return 2.0 * emision.rgb;
}
