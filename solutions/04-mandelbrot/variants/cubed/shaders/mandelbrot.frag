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
vec2 cprod(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}
// END TODO(cprod)

// BEGIN TODO(iterate)
// I(c) of section 4.4, at most maxiter steps.
int iterate(vec2 c) {
    vec2 z = vec2(0.0);
    for (int k = 0; k < maxiter; ++k) {
        z = cprod(z, z) + c;
        if (dot(z, z) > 4.0) {
            return k;  // the first step has index 0
        }
    }
    return 0;
}
// END TODO(iterate)

// BEGIN TODO(colour)
// A grey ramp that begins slowly: the lowest levels differ by 1 / maxiter to the third.
void main() {
    float t = float(iterate(center + zoom * canvas_coord)) / float(maxiter);
    fragColor = vec4(vec3(t * t * t), 1.0);
}
// END TODO(colour)
