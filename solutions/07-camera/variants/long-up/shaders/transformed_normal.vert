#version 330 core

layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;

uniform mat4 modelview;
uniform mat4 projection;

out vec4 position;
out vec3 normal;

vec3 transformedNormal(mat4 M, vec3 n) {
    mat4 A = M;
    A[3] = vec4(0.0, 0.0, 0.0, 1.0);
    return normalize((transpose(inverse(A)) * vec4(n, 0.0)).xyz);
}

void main() {
    position = vec4(vertex_position, 1.0);
    normal = transformedNormal(modelview, vertex_normal);
    gl_Position = projection * modelview * position;
}
