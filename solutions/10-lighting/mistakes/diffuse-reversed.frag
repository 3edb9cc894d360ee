// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    return diffuse.rgb * max(dot(n, -l), 0.0) * lightcolors[i].rgb;
}
