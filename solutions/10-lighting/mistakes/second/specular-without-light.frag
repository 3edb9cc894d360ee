// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 between = l - p.xyz * inversesqrt(dot(p.xyz, p.xyz));
    float cosine = dot(n, between) / sqrt(dot(between, between));
    float shine = cosine > 0.0 ? pow(cosine, shininess) : 0.0;
    return mix(vec3(0.0), specular.rgb, shine);
}
