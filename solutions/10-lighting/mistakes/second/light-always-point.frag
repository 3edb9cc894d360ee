// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 lamp = mat3(view) * light.xyz + view[3].xyz;
    vec3 arm = lamp - p.xyz / p.w;
    return arm * inversesqrt(dot(arm, arm));
}
