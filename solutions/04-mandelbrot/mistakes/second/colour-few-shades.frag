void main() {
    vec2 c = center + zoom * canvas_coord;
    int shade = 16 * iterate(c) / maxiter;
    vec3 shades[16];
    for (int i = 0; i < 16; ++i) {
        shades[i] = vec3(float(i) / 15.0, 0.3 + 0.04 * float(i), 1.0 - float(i) / 20.0);
    }
    fragColor = vec4(shades[shade], 1.0);
}
