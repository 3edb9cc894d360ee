// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    vec3 sum = exposure * pow(emissionPart(), vec3(gamma));
    for (int i = 0; i < nlights; ++i) {
        vec3 one = reflected(i, modelview * position, surfaceNormal());
        sum += exposure * pow(one, vec3(gamma));
    }
    return sum;
}
