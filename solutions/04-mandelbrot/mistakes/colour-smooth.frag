void main() {
    vec2 c = center + zoom * canvas_coord;
    int I = iterate(c);
    vec2 z = vec2(0.0);
    for (int k = 0; k <= I; ++k) {
        z = cprod(z, z) + c;
    }
    float smoothed = dot(z, z) > 4.0 ? float(I) + 1.0 - log2(log2(dot(z, z)) / 2.0) : 0.0;
    float t = smoothed / float(maxiter);
    fragColor = vec4(t, t * t, 0.5 * t, 1.0);
}
