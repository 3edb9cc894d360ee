vec3 transformedNormal() {
    vec3 turned = mat3(modelview) * vertex_normal;
    vec3 moved = turned + modelview[3].xyz;
    return moved / length(moved);
}
