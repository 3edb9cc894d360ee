// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec4 middle = modelview * vec4(0.0, 0.0, 0.0, 1.0);
    vec3 toEye = normalize(vec3(0.0) - middle.xyz / middle.w);
    float shine = pow(max(dot(normalize(l + toEye), n), 0.0), shininess);
    return (shine * lightcolors[i] * specular).rgb;
}
