// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 total = vec3(0.0);
    int k = lightpositions.length();
    while (k > 0) {
        k--;
        total = reflected(k, p, n) + total;
    }
    return total;
}
