// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    vec4 glow = diffuse;
    glow *= emision;
    return vec3(glow);
}
