void main() {
    float x = center.x + zoom * canvas_coord.x;
    float y = center.y - zoom * canvas_coord.y;
    float s = sqrt(float(iterate(vec2(x, y))) / float(maxiter));
    fragColor = vec4(mix(vec3(0.1, 0.0, 0.2), vec3(0.9, 1.0, 0.6), s), 1.0);
}
