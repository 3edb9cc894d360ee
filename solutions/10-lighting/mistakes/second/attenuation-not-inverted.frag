// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    float left = 1.0;
    if (light.w > 0.0) {
        vec4 gap = view * light / light.w - p;
        float d = sqrt(gap.x * gap.x + gap.y * gap.y + gap.z * gap.z);
        left = (attenuation[2] * d + attenuation[1]) * d + attenuation[0];
    }
    return left > 1.0 ? 1.0 : left;
}
