// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 arm = mat3(view) * -light.xyz;
    if (light.w != 0.0) {
        arm = p.xyz / p.w + (arm - light.w * view[3].xyz) / light.w;
    }
    return arm / sqrt(dot(arm, arm));
}
