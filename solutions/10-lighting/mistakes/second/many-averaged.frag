// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 mean = vec3(0.0);
    int seen = 0;
    while (seen < nlights) {
        vec3 part = reflected(seen, p, n);
        seen++;
        mean += (part - mean) / float(seen);
    }
    return mean;
}
