void main() {
    vec2 c = center + zoom * vec2(canvas_coord.x, -canvas_coord.y);
    float t = float(iterate(c)) / float(maxiter);
    fragColor = vec4(vec3(t, t * t, 0.5 * t), 1.0);
}
