void main() {
    float re = center.x + zoom * canvas_coord.y;
    float im = center.y + zoom * canvas_coord.x;
    float s = float(iterate(vec2(re, im))) / float(maxiter);
    float rest = 1.0 - s;
    fragColor = vec4(9.0 * rest * s * s * s, 15.0 * rest * rest * s * s,
                     8.5 * rest * rest * rest * s, 1.0);
}
