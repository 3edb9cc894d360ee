// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 seen = vec3(0.0);
    for (int k = 0; k < 4; k++) {
        seen += light[k] * view[k].xyz;
    }
    return seen / length(seen);
}
