#version 330 core
// AUTHOR: a shader that a student writes has a region like polygon.cpp's, is named in "submit", and
// blanks it by reading the uniform cg_todo_<task>, see assignments/04-mandelbrot.

layout (location = 0) in vec2 vertex_position;
layout (location = 1) in vec3 vertex_color;

uniform vec2 scale;

out vec3 color;

void main() {
    color = vertex_color;
    gl_Position = vec4(scale * vertex_position, 0.0, 1.0);
}
