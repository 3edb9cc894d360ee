// The unit normal in camera coordinates, (7.41).
vec3 transformedNormal() {
    return normalize((modelview * vec4(vertex_normal, 1.0)).xyz);
}
