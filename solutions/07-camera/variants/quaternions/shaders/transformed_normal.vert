#version 330 core

layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;

uniform mat4 modelview;
uniform mat4 projection;

out vec4 position;
out vec3 normal;

// The cofactor matrix: the inverse transpose times the determinant, which is positive.
mat3 cofactors(mat3 m) {
    return mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
}

void main() {
    position = vec4(vertex_position, 1.0);
    normal = normalize(cofactors(mat3(modelview)) * vertex_normal);
    gl_Position = projection * modelview * position;
}
