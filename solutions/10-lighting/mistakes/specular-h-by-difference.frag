// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 v = normalize(-p.xyz);
    vec3 h = normalize(v - l);
    return specular.rgb * pow(max(dot(n, h), 0.0), shininess) * lightcolors[i].rgb;
}
