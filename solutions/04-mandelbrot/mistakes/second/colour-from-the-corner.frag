void main() {
    vec2 P = (canvas_coord + vec2(1.0)) / 2.0;
    vec2 c = mix(center, center + vec2(zoom), P);
    float I = float(iterate(c));
    fragColor = vec4(1.0 - exp(-0.02 * I), 1.0 - exp(-0.05 * I), 1.0 - exp(-0.1 * I), 1.0);
}
