#extension all : require
vec2 cprod(vec2 a, vec2 b) { return a; }
