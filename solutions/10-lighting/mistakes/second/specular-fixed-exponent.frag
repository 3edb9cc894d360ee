// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 between = l - p.xyz * inversesqrt(dot(p.xyz, p.xyz));
    float cosine = clamp(dot(n, between) * inversesqrt(dot(between, between)), 0.0, 1.0);
    float shine = 1.0;
    for (int k = 0; k < 10; k++) {
        shine *= cosine;
    }
    return shine * lightcolors[i].rgb * specular.rgb;
}
