// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    float seen = -dot(n, p.xyz) / length(p.xyz);
    float lit = dot(n, l);
    float shine = 0.0;
    if (seen + lit > 0.0) {
        shine = pow(seen + lit, shininess);
    }
    return shine * lightcolors[i].rgb * specular.rgb;
}
