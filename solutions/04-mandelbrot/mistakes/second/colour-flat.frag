void main() {
    int I = iterate(center + zoom * canvas_coord);
    float s = step(0.0, float(I) / float(maxiter));
    fragColor = vec4(1.0 - s, 0.5 * s, 0.25 + 0.5 * s, 1.0);
}
