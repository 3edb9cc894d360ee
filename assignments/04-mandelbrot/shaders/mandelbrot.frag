#version 330 core
// Colours every pixel by I(c), how long c survives the iteration of section 4.4. You hand this
// file in. Where a region has a line `uniform float cg_todo_...`, take it out with the blank.

in vec2 canvas_coord;  // P of eq. (4.3): x to the right, y upwards, both from -1 to 1

// Your MandelbrotShader sets these; until it does, they keep the values written here.
uniform vec2 center = vec2(0.0);  // the complex number in the middle of the picture
uniform float zoom = 2.0;         // half of the picture's width, > 0
uniform int maxiter = 50;         // n_max of the notes, > 0

out vec4 fragColor;

// BEGIN TODO(cprod)
// The product of two complex numbers; x is the real part, y the imaginary one.
uniform float cg_todo_cprod;
vec2 cprod(vec2 a, vec2 b) {
    return a * b + cg_todo_cprod;
}
// END TODO(cprod)

// BEGIN TODO(iterate)
// I(c) of section 4.4, at most maxiter steps. Until then: rings round 0.
uniform float cg_todo_iterate;
int iterate(vec2 c) {
    return int(6.0 * length(c) + 1.0 + cg_todo_iterate);
}
// END TODO(iterate)

// BEGIN TODO(colour)
// The number c of this pixel, eq. (4.3), its I(c), and for each I(c) a colour that you like.
uniform float cg_todo_colour;
void main() {
    fragColor = vec4(0.5 + 0.5 * canvas_coord, 0.5 + cg_todo_colour, 1.0);
}
// END TODO(colour)
