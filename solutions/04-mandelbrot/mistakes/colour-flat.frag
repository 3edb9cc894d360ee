void main() {
    vec2 c = center + zoom * canvas_coord;
    float t = float(iterate(c)) / float(maxiter);
    fragColor = vec4(vec3(0.2, 0.4, 0.6) + 0.0 * t, 1.0);
}
