// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    vec4 here = modelview * position;
    vec4 lamp = view * lightpositions[i];
    vec3 arm = here.w * lamp.xyz - lamp.w * here.xyz;
    vec3 up = normal * inverse(mat3(modelview));
    float slope = dot(up, arm) * inversesqrt(dot(up, up) * dot(arm, arm));
    vec3 result = lightcolors[i].rgb;
    result *= clamp(slope, 0.0, 1.0);
    return result * ambient.rgb;
}
