#version 330 core
// Puts a vertex through the modelview and projection matrices and its normal through what belongs to
// normals (section 7.5). You hand this file in.

layout (location = 0) in vec3 vertex_position;  // model coordinates
layout (location = 1) in vec3 vertex_normal;    // model coordinates, any length

uniform mat4 modelview;   // model to camera coordinates
uniform mat4 projection;  // camera to clip coordinates

out vec4 position;  // model coordinates
out vec3 normal;    // camera coordinates, length 1

// BEGIN TODO(normal-transform)
// The transposed matrix times a vector is the vector times the matrix.
vec3 transformedNormal() {
    vec4 n = vec4(vertex_normal, 0.0) * inverse(modelview);
    n.w = 0.0;
    return normalize(n).xyz;
}
// END TODO(normal-transform)

void main() {
    position = vec4(vertex_position, 1.0);
    normal = transformedNormal();
    gl_Position = projection * modelview * position;
}
