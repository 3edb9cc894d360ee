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
// Three multiplications in place of four.
vec2 cprod(vec2 p, vec2 q) {
    float first = p.x * q.x;
    float second = p.y * q.y;
    float mixed = (p.x + p.y) * (q.x + q.y);
    return vec2(first - second, mixed - first - second);
}
// END TODO(cprod)

// BEGIN TODO(iterate)
// Without vectors: the squares serve the comparison and the next step.
int iterate(vec2 c) {
    float x = 0.0, y = 0.0, xx = 0.0, yy = 0.0;
    int escape = -1;
    for (int k = 0; escape < 0 && k < maxiter; ++k) {
        y = 2.0 * x * y + c.y;
        x = xx - yy + c.x;
        xx = x * x;
        yy = y * y;
        if (xx + yy > 4.0) {
            escape = k;
        }
    }
    return max(escape, 0);
}
// END TODO(iterate)

// BEGIN TODO(colour)
// Night to dawn: every channel of a geometric series, brighter where the escape takes long.
void main() {
    float re = canvas_coord.x * zoom + center.x;
    float im = canvas_coord.y * zoom + center.y;
    float I = float(iterate(vec2(re, im)));
    vec3 night = vec3(0.02, 0.02, 0.12), dawn = vec3(1.0, 0.75, 0.55);
    vec3 amount = 1.0 - pow(vec3(0.97, 0.985, 0.99), vec3(I));
    fragColor = vec4(mix(night, dawn, amount), 1.0);
}
// END TODO(colour)
