vec3 transformedNormal() {
    vec3 a = modelview[0].xyz;
    vec3 b = modelview[1].xyz;
    vec3 c = modelview[2].xyz;
    mat3 cofactors = mat3(cross(b, c), cross(c, a), cross(a, b));
    return cofactors * vertex_normal / dot(a, cofactors[0]);
}
