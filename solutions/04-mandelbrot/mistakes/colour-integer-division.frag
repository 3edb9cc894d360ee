void main() {
    vec2 c = center + zoom * canvas_coord;
    float t = float(iterate(c) / maxiter);
    fragColor = vec4(vec3(t, t * t, 0.5 * t), 1.0);
}
