void main() {
    vec2 c = center + zoom * canvas_coord;
    int I = iterate(c);
    float t = I == maxiter - 1 ? 0.0 : float(I) / float(maxiter);
    fragColor = vec4(vec3(t, t * t, 0.5 * t), 1.0);
}
