// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    return exposure * pow(min(light, 1.0), vec3(gamma));
}
