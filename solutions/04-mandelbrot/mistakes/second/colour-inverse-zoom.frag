void main() {
    float scale = 1.0 / zoom;
    float re = center.x + scale * canvas_coord.x;
    float im = center.y + scale * canvas_coord.y;
    float s = float(iterate(vec2(re, im))) / float(maxiter);
    fragColor = vec4(1.0 - s, 1.0 - s * s, 1.0, 1.0);
}
