// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    float cosine = l.x * n.x + l.y * n.y + l.z * n.z;
    vec4 part = lightcolors[i] * diffuse;
    part *= cosine < 0.0 ? -cosine : 0.0;
    return part.rgb;
}
