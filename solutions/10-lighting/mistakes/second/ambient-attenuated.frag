// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    vec4 lamp = view * lightpositions[i];
    vec4 here = modelview * position;
    float weaker = 1.0;
    if (lamp.w > 0.0) {
        vec3 arm = lamp.xyz / lamp.w - here.xyz;
        float d2 = dot(arm, arm);
        float c = dot(attenuation, vec3(1.0, sqrt(d2), d2));
        weaker = 1.0 / max(c, 1.0);
    }
    return weaker * (lightcolors[i] * ambient).xyz;
}
