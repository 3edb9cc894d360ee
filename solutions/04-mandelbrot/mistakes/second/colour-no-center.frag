void main() {
    float re = canvas_coord.x * zoom;
    float im = canvas_coord.y * zoom;
    int I = iterate(vec2(re, im));
    vec3 shade = 0.5 - 0.5 * cos(float(I) * vec3(0.11, 0.17, 0.23));
    fragColor = vec4(shade, 1.0);
}
