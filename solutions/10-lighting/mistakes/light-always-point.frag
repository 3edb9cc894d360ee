// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec4 place = view * vec4(light.xyz, 1.0);
    return normalize(place.xyz - p.xyz);
}
