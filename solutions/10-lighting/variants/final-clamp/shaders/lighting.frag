#version 330 core
// Equally right: what was mapped is cut off to 0 to 1 at the very end, as the screen would do, and
// the lights are added from the last to the first.
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

void main() {
    vec3 n = normalize(inverse(transpose(mat3(modelview))) * normal);
    if (!enablelighting) {
        fragColor = vec4(abs(n), 1.0);
        return;
    }
    vec3 p = vec3(modelview * position);
    vec3 v = -normalize(p);
    vec3 light = emision.rgb;
    for (int i = nlights - 1; i >= 0; i--) {
        vec4 lamp = view * lightpositions[i];
        vec3 l = lamp.xyz;
        float left = 1.0;
        if (lamp.w != 0.0) {
            l = lamp.xyz / lamp.w - p;
            float d = length(l);
            left = min(1.0 / dot(attenuation, vec3(1.0, d, d * d)), 1.0);
        }
        l = normalize(l);
        float lit = max(dot(n, l), 0.0);
        float shine = pow(max(dot(n, normalize(v + l)), 0.0), shininess);
        light += lightcolors[i].rgb *
                 (ambient.rgb + left * (lit * diffuse.rgb + shine * specular.rgb));
    }
    fragColor = vec4(clamp(exposure * pow(light, vec3(gamma)), 0.0, 1.0), 1.0);
}
