// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    float exponent = 1.0 / gamma;
    for (int k = 0; k < 3; k++) {
        light[k] = pow(light[k], exponent);
    }
    light *= exposure;
    return light;
}
