void main() {
    vec2 c = center + zoom * canvas_coord.yx;
    float t = float(iterate(c)) / float(maxiter);
    fragColor = vec4(vec3(t, t * t, 0.5 * t), 1.0);
}
