vec3 transformedNormal() {
    vec3 right = vec3(1.0, 0.0, 0.0);
    vec3 top = vec3(0.0, 1.0, 0.0);
    return normalize(cross(right, top));
}
