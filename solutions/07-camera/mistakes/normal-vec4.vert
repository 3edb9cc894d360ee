// The unit normal in camera coordinates, (7.41).
vec3 transformedNormal() {
    return normalize(transpose(inverse(modelview)) * vec4(vertex_normal, 0.0)).xyz;
}
