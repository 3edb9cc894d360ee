// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 place = light.xyz;
    if (light.w > 0.0) {
        place /= light.w;
    }
    return place * inversesqrt(dot(place, place));
}
