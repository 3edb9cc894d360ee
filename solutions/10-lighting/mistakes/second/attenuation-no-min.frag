// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    float c = 1.0;
    if (light.w > 0.0) {
        vec3 gap = mat3(view) * (light.xyz / light.w) + view[3].xyz - p.xyz;
        float d = sqrt(dot(gap, gap));
        c = dot(attenuation, vec3(1.0, d, d * d));
    }
    return 1.0 / c;
}
