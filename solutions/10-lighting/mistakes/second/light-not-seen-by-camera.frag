// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    if (light.w == 0.0) {
        return light.xyz / length(light.xyz);
    }
    vec3 arm = light.xyz / light.w - p.xyz / p.w;
    return arm * inversesqrt(dot(arm, arm));
}
