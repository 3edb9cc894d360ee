#version 330 core

layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;

uniform mat4 modelview;
uniform mat4 projection;

out vec4 position;
out vec3 normal;

// Two tangents go through modelview as displacements do; the normal is orthogonal to both.
vec3 transformedNormal() {
    vec3 n = normalize(vertex_normal);
    vec3 other = abs(n.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 tangent = normalize(cross(other, n));
    vec3 bitangent = cross(n, tangent);
    vec3 first = (modelview * vec4(tangent, 0.0)).xyz;
    vec3 second = (modelview * vec4(bitangent, 0.0)).xyz;
    return normalize(cross(first, second));
}

void main() {
    position = vec4(vertex_position, 1.0);
    normal = transformedNormal();
    gl_Position = projection * modelview * position;
}
