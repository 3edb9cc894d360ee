// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    return float(nlights) * emision.rgb;
}
