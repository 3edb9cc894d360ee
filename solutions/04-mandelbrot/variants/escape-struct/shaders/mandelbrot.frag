#version 330 core
// One struct for all that the iteration knows, the pixel's c between two corners, and a spiral
// through the colour cube. No regions.
uniform vec2 center;
uniform float zoom;
uniform int maxiter;
in vec2 canvas_coord;
layout(location = 0) out vec4 color;

struct Orbit {
    vec2 c, z;
    int steps;
};

void advance(inout Orbit orbit) {
    vec2 z = orbit.z;
    orbit.z = vec2(dot(z, vec2(z.x, -z.y)), dot(z, z.yx)) + orbit.c;
    ++orbit.steps;
}

bool hasLeft(Orbit orbit) {
    return distance(orbit.z, vec2(0.0)) > 2.0;
}

vec3 helix(float brightness) {
    float angle = 6.2832 * (0.2 - 1.1 * brightness);
    float amplitude = 0.6 * brightness * (1.0 - brightness);
    mat2x3 plane = mat2x3(-0.15, -0.29, 1.97, 1.78, -0.91, 0.0);
    return brightness + amplitude * (plane * vec2(cos(angle), sin(angle)));
}

void main() {
    vec2 lowerLeft = center - zoom, upperRight = center + zoom;
    Orbit orbit;
    orbit.c = mix(lowerLeft, upperRight, 0.5 + 0.5 * canvas_coord);
    orbit.z = vec2(0.0);
    orbit.steps = 0;
    do {
        advance(orbit);
    } while (!hasLeft(orbit) && orbit.steps < maxiter);

    vec3 shade = vec3(1.0, 0.98, 0.94);
    if (hasLeft(orbit)) {
        shade = helix(float(orbit.steps - 1) / float(maxiter));
    }
    color = vec4(shade, 1.0);
}
