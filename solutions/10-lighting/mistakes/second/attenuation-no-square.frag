// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    if (light.w != 0.0) {
        vec3 toLight = (view * (light / light.w) - p).xyz;
        float sum = attenuation[0];
        for (int k = 1; k <= 2; k++) {
            sum += attenuation[k] * length(toLight);
        }
        return 1.0 / max(1.0, sum);
    }
    return 1.0;
}
