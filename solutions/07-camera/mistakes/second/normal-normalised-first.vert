vec3 transformedNormal() {
    mat3 block = mat3(modelview[0].xyz, modelview[1].xyz, modelview[2].xyz);
    vec3 unit = vertex_normal / length(vertex_normal);
    return unit * inverse(block);
}
