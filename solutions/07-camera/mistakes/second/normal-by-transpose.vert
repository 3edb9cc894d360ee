vec3 transformedNormal() {
    vec3 n = vec3(dot(modelview[0].xyz, vertex_normal), dot(modelview[1].xyz, vertex_normal),
                  dot(modelview[2].xyz, vertex_normal));
    return inversesqrt(dot(n, n)) * n;
}
