// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    return i == 0 ? ambient.rgb : vec3(0.0);
}
