// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    light *= exposure;
    light.r = pow(light.r, gamma);
    light.g = pow(light.g, gamma);
    light.b = pow(light.b, gamma);
    return light;
}
