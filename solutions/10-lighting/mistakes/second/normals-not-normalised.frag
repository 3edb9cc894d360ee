// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    mat3 back = inverse(mat3(modelview));
    float x = dot(normal, back[0]);
    float y = dot(normal, back[1]);
    float z = dot(normal, back[2]);
    return vec3(x, y, z);
}
