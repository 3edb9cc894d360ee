vec3 transformedNormal() {
    mat4 back = inverse(modelview);
    vec4 n = back * vec4(vertex_normal, 0.0);
    n.w = 0.0;
    return normalize(n).xyz;
}
