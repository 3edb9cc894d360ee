// The unit normal in camera coordinates, (7.41).
vec3 transformedNormal() {
    return vec3(0.0, 0.0, 1.0);
}
