// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    mat3 A = mat3(modelview);
    vec3 turned = mat3(cross(A[2], A[1]), cross(A[0], A[2]), cross(A[1], A[0])) * normal;
    return turned / length(turned);
}
