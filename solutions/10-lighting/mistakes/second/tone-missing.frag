// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    vec4 shown = vec4(0.0, 0.0, 0.0, 1.0);
    shown.rgb += light;
    return shown.rgb;
}
