// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    return vec3(0.0);
}
