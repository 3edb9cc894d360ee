// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    return ambient.rgb * lightcolors[i].rgb *
           max(dot(surfaceNormal(), lightDirection(lightpositions[i], modelview * position)), 0.0);
}
