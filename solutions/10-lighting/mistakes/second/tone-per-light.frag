// The final colour, each channel mapped by (10.2).
vec3 mapOne(vec3 part) {
    return vec3(pow(part.r, gamma), pow(part.g, gamma), pow(part.b, gamma)) * exposure;
}
vec3 toneMapped(vec3 light) {
    vec4 here = modelview * position;
    vec3 up = surfaceNormal();
    vec3 total = vec3(0.0);
    int k = nlights - 1;
    while (k >= 0) {
        total += mapOne(reflected(k, here, up));
        k--;
    }
    return total + mapOne(emissionPart());
}
