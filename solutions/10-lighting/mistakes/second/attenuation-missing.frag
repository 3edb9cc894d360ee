// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    const float c0 = 1.0, c1 = 0.0, c2 = 0.0;
    if (light.w > 0.0) {
        float d = length((view * light).xyz / light.w - p.xyz);
        return clamp(1.0 / (c0 + (c1 + c2 * d) * d), 0.0, 1.0);
    }
    return c0;
}
