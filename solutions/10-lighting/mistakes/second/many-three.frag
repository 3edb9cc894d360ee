// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 first = reflected(0, p, n);
    vec3 second = reflected(1, p, n);
    vec3 third = reflected(2, p, n);
    return first + second + third;
}
