// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    return light;
}
