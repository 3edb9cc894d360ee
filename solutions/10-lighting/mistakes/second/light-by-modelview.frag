// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec4 seen = modelview * light;
    if (seen.w > 0.0) {
        vec3 arm = seen.xyz / seen.w - p.xyz / p.w;
        return arm / length(arm);
    }
    return seen.xyz / length(seen.xyz);
}
