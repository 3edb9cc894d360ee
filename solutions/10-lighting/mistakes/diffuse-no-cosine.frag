// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    return diffuse.rgb * step(0.0, dot(n, l)) * lightcolors[i].rgb;
}
