vec3 transformedNormal() {
    vec4 direction = vec4(vertex_normal, 0.0);
    direction = inverse(modelview) * (modelview * direction);
    return direction.xyz;
}
