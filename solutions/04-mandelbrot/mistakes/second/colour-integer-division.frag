void main() {
    vec3 sea = vec3(0.05, 0.1, 0.35), sand = vec3(0.95, 0.85, 0.5);
    vec2 c = canvas_coord * zoom + center;
    int shade = iterate(c) / maxiter;
    fragColor.rgb = sea + shade * (sand - sea);
    fragColor.a = 1.0;
}
