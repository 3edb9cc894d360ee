// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    vec4 turned = modelview * vec4(normal, 0.0);
    return turned.xyz * inversesqrt(dot(turned.xyz, turned.xyz));
}
