// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 total = vec3(0.0);
    int k = nlights;
    while (--k > 0) {
        total += reflected(k, p, n);
    }
    return total;
}
