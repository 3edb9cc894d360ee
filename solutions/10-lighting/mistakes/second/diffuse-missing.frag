// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    vec4 part = vec4(0.0, 0.0, 0.0, 1.0);
    return part.rgb;
}
