// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    float slope = 0.0;
    for (int k = 0; k < 3; k++) {
        slope += l[k] * n[k];
    }
    vec4 part = lightcolors[i] * slope;
    part *= diffuse;
    return part.rgb;
}
