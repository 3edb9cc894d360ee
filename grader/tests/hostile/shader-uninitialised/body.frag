void main() {
    if (canvas_coord.x > 1000.0) fragColor = vec4(float(iterate(canvas_coord)));
}
