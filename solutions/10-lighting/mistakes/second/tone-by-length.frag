// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    float strength = sqrt(dot(light, light));
    if (strength < 1e-6) {
        return vec3(0.0);
    }
    vec3 hue = light / strength;
    return pow(strength, gamma) * exposure * hue;
}
