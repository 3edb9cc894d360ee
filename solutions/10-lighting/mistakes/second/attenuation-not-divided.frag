// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    float left = 1.0;
    if (light.w > 0.0) {
        vec3 arm = mat3(view) * light.xyz + light.w * (view[3].xyz - p.xyz);
        float squared = dot(arm, arm);
        left /= max(dot(attenuation.yz, vec2(sqrt(squared), squared)) + attenuation.x, 1.0);
    }
    return left;
}
