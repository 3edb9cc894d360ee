// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 between = vec3(l.xy, l.z + 1.0);
    float cosine = dot(n, between) * inversesqrt(dot(between, between));
    if (cosine <= 0.0) {
        return vec3(0.0);
    }
    return lightcolors[i].rgb * pow(cosine, shininess) * specular.rgb;
}
