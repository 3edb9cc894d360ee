// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    return normalize(transpose(inverse(mat3(modelview))) * -normal);
}
