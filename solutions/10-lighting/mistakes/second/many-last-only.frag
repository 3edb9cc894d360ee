// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    if (nlights < 1) {
        return vec3(0.0);
    }
    return reflected(nlights - 1, p, n);
}
