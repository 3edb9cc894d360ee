void main() {
    float zero = center.x - center.x;
    fragColor = vec4(zero / zero + float(iterate(canvas_coord)) * zero);
}
