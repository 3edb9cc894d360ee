// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    if (l.x * n.x + l.y * n.y + l.z * n.z < 0.0) {
        return vec3(0.0);
    }
    return (lightcolors[i] * diffuse).xyz;
}
