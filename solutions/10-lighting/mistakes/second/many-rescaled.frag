// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 v = normalize(-p.xyz);
    vec3 total = vec3(0.0);
    for (int k = 0; k < nlights; k++) {
        vec3 l = lightDirection(lightpositions[k], p);
        float cosine = max(dot(n, l), 0.0);
        float shine = pow(max(dot(n, normalize(l + v)), 0.0), shininess);
        vec3 directed = cosine * diffuse.rgb + shine * specular.rgb;
        total += ambient.rgb + lightLeft(lightpositions[k], p) * directed;
        total *= lightcolors[k].rgb;
    }
    return total;
}
