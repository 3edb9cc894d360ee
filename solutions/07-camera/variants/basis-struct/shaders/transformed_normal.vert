#version 330 core

layout(location = 1) in vec3 vertex_normal;
layout(location = 0) in vec3 vertex_position;

uniform mat4 projection, modelview;

out vec3 normal;
out vec4 position;

void main() {
    mat3 inverted = inverse(mat3(modelview));
    for (int i = 0; i < 3; ++i) {
        normal[i] = dot(inverted[i], vertex_normal);
    }
    normal *= inversesqrt(dot(normal, normal));
    position = vec4(vertex_position, 1);
    gl_Position = projection * (modelview * position);
}
