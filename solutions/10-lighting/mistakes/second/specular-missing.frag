// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 shine = specular.rgb;
    shine *= 0.0;
    return shine;
}
