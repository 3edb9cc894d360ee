// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec4 place = view * light;
    return normalize(place.xyz - p.xyz);
}
