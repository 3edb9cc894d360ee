vec3 transformedNormal() {
    vec4 direction = modelview * vec4(vertex_normal, 0.0);
    return direction.xyz / length(direction.xyz);
}
