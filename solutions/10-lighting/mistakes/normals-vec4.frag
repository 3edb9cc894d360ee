// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    return normalize(transpose(inverse(modelview)) * vec4(normal, 0.0)).xyz;
}
