// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    vec4 here = modelview * position;
    float slope = -dot(n, here.xyz) / length(here.xyz);
    vec3 result = vec3(0.0);
    if (slope > 0.0) {
        result = slope * lightcolors[i].rgb;
    }
    return result * diffuse.rgb;
}
