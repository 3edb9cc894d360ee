// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    float c0 = attenuation[0];
    bool nearby = light.w != 0.0;
    return nearby && c0 > 1.0 ? 1.0 / c0 : 1.0;
}
