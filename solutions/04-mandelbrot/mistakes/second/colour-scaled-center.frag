void main() {
    vec2 P = canvas_coord + center;
    P *= zoom;
    float I = float(iterate(P));
    fragColor = vec4(I / (I + 8.0), I / (I + 20.0), I / (I + 50.0), 1.0);
}
