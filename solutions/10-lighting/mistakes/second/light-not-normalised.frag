// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec4 seen = view * light;
    vec3 arm;
    for (int k = 0; k < 3; k++) {
        arm[k] = seen[k] * p.w - p[k] * seen.w;
    }
    return arm;
}
