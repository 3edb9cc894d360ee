// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 arm = vec3(view * light);
    bool atInfinity = light.w == 0.0;
    if (!atInfinity) {
        arm -= p.xyz;
    }
    return arm / sqrt(dot(arm, arm));
}
