#version 330 core

layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;

uniform mat4 modelview;
uniform mat4 projection;

out vec4 position;
out vec3 normal;

// BEGIN TODO(normal-transform)
vec3 row(int i) {
    return vec3(modelview[0][i], modelview[1][i], modelview[2][i]);
}

vec3 transformedNormal() {
    vec3 r0 = row(0), r1 = row(1), r2 = row(2);
    vec3 n = vec3(dot(cross(r1, r2), vertex_normal), dot(cross(r2, r0), vertex_normal),
                  dot(cross(r0, r1), vertex_normal));
    return n / sqrt(dot(n, n));
}
// END TODO(normal-transform)

void main() {
    position = vec4(vertex_position, 1.0);
    normal = transformedNormal();
    gl_Position = projection * modelview * position;
}
