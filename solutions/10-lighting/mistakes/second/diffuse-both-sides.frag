// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    vec3 litSide = faceforward(n, -l, n);
    float cosine = dot(litSide, l);
    return cosine * (diffuse * lightcolors[i]).rgb;
}
