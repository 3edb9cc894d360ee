#version 330 core
// Lays the canvas: a square over the whole picture, whose place P in [-1, 1] x [-1, 1] is handed
// down to the fragment shader (exercise 4.1). x grows to the right, y grows upwards.

layout (location = 0) in vec2 vertex_position;

out vec2 canvas_coord;  // P

void main() {
    canvas_coord = vertex_position;
    gl_Position = vec4(vertex_position, 0.0, 1.0);
}
