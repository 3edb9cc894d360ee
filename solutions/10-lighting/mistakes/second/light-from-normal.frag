// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 here = normal * inverse(mat3(modelview));
    here /= length(here);
    vec4 seen = view * light;
    vec3 arm = seen.w > 0.0 ? seen.xyz / seen.w - here : seen.xyz;
    return arm / length(arm);
}
