void main() {
    int I = iterate(center + zoom * canvas_coord);
    I -= I % 2;
    float s = float(I) / float(maxiter);
    fragColor = vec4(0.8 * sqrt(s), 1.0 - s, 0.4 + 0.6 * s * s, 1.0);
}
