// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    float slope = clamp(n.x * l.x + n.y * l.y + n.z * l.z, 0.0, 1.0);
    vec3 received = slope * lightcolors[i].rgb;
    vec3 given = slope * diffuse.rgb;
    return received * given;
}
