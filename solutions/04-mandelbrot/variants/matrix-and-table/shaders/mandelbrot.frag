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
// BEGIN TODO(cprod)
// Multiplying by a is a linear map of the plane: a turn and a stretch.
vec2 cprod(vec2 a, vec2 b) {
    return mat2(a, vec2(-a.y, a.x)) * b;
}
// END TODO(cprod)

// BEGIN TODO(iterate)
// Counts how often z stays in the circle; the next step is the one that leaves.
int iterate(vec2 c) {
    vec2 z = c;
    int k = 0;
    while (k < maxiter && length(z) <= 2.0) {
        z = cprod(z, z) + c;
        ++k;
    }
    return k < maxiter ? k : 0;
}
// END TODO(iterate)

// BEGIN TODO(colour)
// Seven colours, over and over; the inside and the far outside are dark.
const vec3 colours[7] =
    vec3[7](vec3(0.95, 0.77, 0.06), vec3(0.90, 0.49, 0.13), vec3(0.75, 0.22, 0.17),
            vec3(0.56, 0.27, 0.68), vec3(0.16, 0.50, 0.73), vec3(0.09, 0.63, 0.52),
            vec3(0.15, 0.68, 0.38));

void main() {
    int I = iterate(center + zoom * canvas_coord);
    if (I == 0) {
        fragColor = vec4(0.07, 0.06, 0.1, 1.0);
        return;
    }
    fragColor = vec4(colours[I % 7], 1.0);
}
// END TODO(colour)
