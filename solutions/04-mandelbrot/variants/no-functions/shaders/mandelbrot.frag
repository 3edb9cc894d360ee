#version 330 core
in vec2 canvas_coord;
uniform vec2 center;
uniform float zoom;
uniform int maxiter;
out vec4 fragColor;

void main(void) {
    vec2 c = center + zoom * canvas_coord;
    int I = 0;
    vec2 z = vec2(0.0, 0.0);
    for (int k = 0; k < maxiter; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        if (length(z) > 2.0) {
            I = k;
            break;
        }
    }
    float s = float(I) / float(maxiter);
    fragColor = vec4(s, 0.5 * s, 1.0 - s, 0.0);
}
