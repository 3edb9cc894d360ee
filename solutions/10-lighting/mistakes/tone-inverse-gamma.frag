// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    return exposure * pow(light, vec3(1.0 / gamma));
}
