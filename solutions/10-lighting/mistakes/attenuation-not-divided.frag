// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    if (light.w == 0.0) return 1.0;
    vec4 place = view * light;
    float d = length(p.w * place.xyz - place.w * p.xyz);
    return min(1.0 / (attenuation.x + attenuation.y * d + attenuation.z * d * d), 1.0);
}
