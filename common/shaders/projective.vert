#version 330 core
// Puts a vertex through the modelview and projection matrices (section 7.6.3).

layout (location = 0) in vec3 vertex_position;  // model coordinates
layout (location = 1) in vec3 vertex_normal;    // model coordinates, unit length

uniform mat4 modelview;   // model to camera coordinates
uniform mat4 projection;  // camera to clip coordinates

// What the fragment shader gets, still in model coordinates.
out vec4 position;
out vec3 normal;

void main() {
    position = vec4(vertex_position, 1.0);
    normal = vertex_normal;
    gl_Position = projection * modelview * position;
}
