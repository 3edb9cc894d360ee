// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 between = -p.xyz / length(p.xyz) - l;
    between *= inversesqrt(dot(between, between));
    float cosine = between.x * n.x + between.y * n.y + between.z * n.z;
    vec4 part = lightcolors[i] * specular;
    part *= cosine < 0.0 ? 0.0 : pow(cosine, shininess);
    return part.rgb;
}
