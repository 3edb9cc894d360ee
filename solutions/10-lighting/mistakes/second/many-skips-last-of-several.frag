// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 total = vec3(0.0);
    int k = 0;
    do {
        total += reflected(k, p, n);
        k++;
    } while (k < nlights - 1);
    return total;
}
