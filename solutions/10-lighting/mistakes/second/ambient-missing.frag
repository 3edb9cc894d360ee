// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    const float share = 0.0;
    return share * ambient.rgb * lightcolors[i].rgb;
}
