// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    vec3 mapped;
    for (int k = 0; k < 3; k++) {
        float channel = light[k] > 1.0 ? 1.0 : light[k];
        mapped[k] = pow(channel, gamma) * exposure;
    }
    return mapped;
}
