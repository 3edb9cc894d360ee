void main() {
    vec2 c = center + zoom * canvas_coord, z = c;
    int n = iterate(c);
    for (int i = 0; i < n; i++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
    }
    float mu = 0.0;
    if (length(z) > 2.0) {
        mu = float(n + 1) - log(log(length(z)) / log(2.0)) / log(2.0);
    }
    fragColor = vec4(0.5 - 0.5 * cos(vec3(0.05, 0.08, 0.12) * mu), 1.0);
}
