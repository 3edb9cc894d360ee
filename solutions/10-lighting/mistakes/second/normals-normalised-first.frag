// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    vec3 unit = normal / length(normal);
    vec3 a = modelview[0].xyz, b = modelview[1].xyz, c = modelview[2].xyz;
    mat3 cofactors = mat3(cross(b, c), cross(c, a), cross(a, b));
    return cofactors * unit / dot(a, cofactors[0]);
}
