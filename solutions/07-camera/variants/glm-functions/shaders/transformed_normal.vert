#version 330 core

layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;

uniform mat4 modelview;
uniform mat4 projection;

out vec4 position;
out vec3 normal;

void main() {
    position = vec4(vertex_position, 1.0);
    normal = normalize(mat3(transpose(inverse(modelview))) * vertex_normal);
    gl_Position = projection * modelview * position;
}
