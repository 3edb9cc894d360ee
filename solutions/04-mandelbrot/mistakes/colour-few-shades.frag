void main() {
    vec2 c = center + zoom * canvas_coord;
    float t = floor(16.0 * float(iterate(c)) / float(maxiter)) / 16.0;
    fragColor = vec4(vec3(t, t * t, 0.5 * t), 1.0);
}
