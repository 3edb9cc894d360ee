// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 toEye = -p.xyz / length(p.xyz);
    vec3 mirrored = 2.0 * dot(toEye, n) * n - toEye;
    float cosine = dot(mirrored, l);
    if (cosine <= 0.0) {
        return vec3(0.0);
    }
    return pow(cosine, shininess) * (lightcolors[i] * specular).rgb;
}
