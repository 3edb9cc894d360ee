// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    float squared = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
    return normal / sqrt(squared);
}
