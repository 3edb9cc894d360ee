// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    vec3 a = modelview[0].xyz, b = modelview[1].xyz, c = modelview[2].xyz;
    vec3 bc = cross(b, c);
    vec3 n = vec3(dot(bc, normal), dot(cross(c, a), normal), dot(cross(a, b), normal));
    n /= dot(a, bc);
    return n / length(n);
}
