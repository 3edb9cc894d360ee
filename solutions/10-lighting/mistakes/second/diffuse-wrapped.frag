// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    const float low = -1.0, high = 1.0;
    float slope = n.x * l.x + n.y * l.y + n.z * l.z;
    float share = (slope - low) / (high - low);
    return vec3(lightcolors[i] * mix(vec4(0.0), diffuse, share));
}
