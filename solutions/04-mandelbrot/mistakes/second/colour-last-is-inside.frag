void main() {
    vec3 ink = vec3(0.02, 0.05, 0.1);
    int level = iterate(center + canvas_coord * zoom) % (maxiter - 1);
    vec3 glow = vec3(1.0, 0.7, 0.3) * log(1.0 + float(level));
    fragColor = vec4(ink + glow / 5.0, 1.0);
}
