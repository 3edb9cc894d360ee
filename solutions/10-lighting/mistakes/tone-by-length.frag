// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    return exposure * light * pow(max(length(light), 1e-6), gamma - 1.0);
}
