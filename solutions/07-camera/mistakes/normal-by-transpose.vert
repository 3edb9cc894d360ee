// The unit normal in camera coordinates, (7.41).
vec3 transformedNormal() {
    return normalize(transpose(mat3(modelview)) * vertex_normal);
}
