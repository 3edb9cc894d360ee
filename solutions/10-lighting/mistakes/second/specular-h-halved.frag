// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 toEye = -p.xyz / length(p.xyz);
    vec3 between = mix(toEye, l, 0.5);
    float cosine = clamp(dot(between, n), 0.0, 1.0);
    return (pow(cosine, shininess) * lightcolors[i] * specular).rgb;
}
