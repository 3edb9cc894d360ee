// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    vec4 turned = vec4(normal, 0.0) * inverse(modelview);
    turned /= length(turned);
    return vec3(turned);
}
