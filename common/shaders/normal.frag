#version 330 core
// Colours a surface by its normal, eq. (7.42): every component moves from [-1,1] to [0,1]. The
// normal is the one of the model, so a face keeps its colour however the model is turned.

in vec4 position;  // model coordinates; not needed here
in vec3 normal;    // model coordinates; interpolation may have changed its length

uniform mat4 modelview;  // not needed here

out vec4 fragColor;

void main() {
    vec3 direction = normalize(normal);
    fragColor = vec4(0.5 * direction + 0.5, 1.0);
}
