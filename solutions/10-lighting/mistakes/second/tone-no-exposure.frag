// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    float r = pow(light.r, gamma);
    float g = pow(light.g, gamma);
    float b = pow(light.b, gamma);
    return vec3(r, g, b);
}
