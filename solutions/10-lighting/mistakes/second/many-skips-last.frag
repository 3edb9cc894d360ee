// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 total = vec3(0.0);
    int k = 1;
    while (k < nlights) {
        total += reflected(k - 1, p, n);
        k++;
    }
    return total;
}
