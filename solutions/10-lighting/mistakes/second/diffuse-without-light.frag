// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    float slope = n.x * l.x + n.y * l.y + n.z * l.z;
    if (slope < 0.0) {
        slope = 0.0;
    }
    return mix(vec3(0.0), diffuse.rgb, slope);
}
