vec3 transformedNormal() {
    vec4 n = vec4(vertex_normal, 0.0) * inverse(modelview);
    n /= sqrt(n.x * n.x + n.y * n.y + n.z * n.z + n.w * n.w);
    return vec3(n.x, n.y, n.z);
}
