void main() {
    float zero = center.x - center.x;
    fragColor = vec4(1.0 / zero, -1.0 / zero, float(1 + iterate(canvas_coord)) / zero, 1.0 / zero);
}
