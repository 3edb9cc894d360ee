#version 450
vec2 cprod(vec2 a, vec2 b) { return a; }
