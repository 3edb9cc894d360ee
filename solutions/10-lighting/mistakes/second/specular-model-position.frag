// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 eye = vec3(0.0, 0.0, 0.0);
    vec3 toEye = eye - position.xyz / position.w;
    toEye /= length(toEye);
    vec3 between = l + toEye;
    float cosine = dot(n, between) / length(between);
    float shine = cosine > 0.0 ? pow(cosine, shininess) : 0.0;
    return shine * (lightcolors[i] * specular).rgb;
}
