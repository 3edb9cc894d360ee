// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    vec3 everywhere = vec3(0.0);
    for (int channel = 0; channel < 3; channel++) {
        everywhere[channel] = ambient[channel];
    }
    return everywhere;
}
