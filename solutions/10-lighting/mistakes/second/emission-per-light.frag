// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    vec3 glow = vec3(0.0);
    int k = nlights;
    while (k-- > 0) {
        glow += vec3(emision);
    }
    return glow;
}
