// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    vec3 lamp = lightcolors[0].xyz;
    return vec3(lamp.r * emision.r, lamp.g * emision.g, lamp.b * emision.b);
}
