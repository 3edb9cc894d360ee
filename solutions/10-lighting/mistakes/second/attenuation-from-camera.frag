// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    float left = 1.0;
    if (light.w > 0.0) {
        float squared = dot(p.xyz, p.xyz);
        float c = attenuation[0] + sqrt(squared) * attenuation[1] + squared * attenuation[2];
        if (c > 1.0) left /= c;
    }
    return left;
}
