// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < nlights - 1; ++i) {
        sum += reflected(i, p, n);
    }
    return sum;
}
