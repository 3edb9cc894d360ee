#version 330 core
// Equally right: eye and lights are brought to the model, where lengths and angles are measured by
// the matrix G = transpose(M) M.
in vec4 position;
in vec3 normal;

uniform mat4 view;
uniform mat4 modelview;
uniform vec4 ambient, diffuse, specular, emision;
uniform float shininess;
uniform bool enablelighting;
uniform int nlights;
uniform vec4 lightpositions[10];
uniform vec4 lightcolors[10];
uniform vec3 attenuation;
uniform float exposure;
uniform float gamma;

out vec4 fragColor;

mat3 G = transpose(mat3(modelview)) * mat3(modelview);

float measured(vec3 arrow) {
    return sqrt(dot(arrow, G * arrow));
}

void main() {
    mat4 fromCamera = inverse(modelview);
    mat4 fromWorld = fromCamera * view;
    vec3 here = position.xyz / position.w;
    // A normal pairs with arrows; this is its length among cameras.
    vec3 n = normal / sqrt(dot(normal, inverse(G) * normal));
    vec3 v = fromCamera[3].xyz - here;
    v /= measured(v);

    vec4 light = vec4(emision.rgb, 1.0);
    for (int i = 0; i < nlights; i++) {
        vec4 lamp = fromWorld * lightpositions[i];
        float w = lightpositions[i].w;
        vec3 l = w == 0.0 ? lamp.xyz : lamp.xyz / w - here;
        float d = measured(l);
        l /= d;
        vec3 h = v + l;
        h /= measured(h);
        float f = 1.0;
        if (w != 0.0) f = min(1.0, 1.0 / dot(vec3(1.0, d, d * d), attenuation));
        vec4 directed = max(dot(n, l), 0.0) * diffuse;
        directed += pow(max(dot(n, h), 0.0), shininess) * specular;
        light += (f * directed + ambient) * lightcolors[i];
    }
    if (enablelighting)
        fragColor = exposure * pow(light, vec4(gamma));
    else
        fragColor = vec4(normalize(abs(normal)), 1.0);
}
