#version 330 core
// Equally right: (10.22) with an if, no highlight where the light does not reach, a light at
// infinity that attenuation with c1 or c2 puts out, fragColor summed up term by term.
in vec4 position;
in vec3 normal;
uniform mat4 view;
uniform mat4 modelview;
uniform vec4 ambient;
uniform vec4 diffuse;
uniform vec4 specular;
uniform vec4 emision;
uniform float shininess;
const int maximal_number = 10;
uniform bool enablelighting;
uniform int nlights;
uniform vec4 lightpositions[maximal_number];
uniform vec4 lightcolors[maximal_number];
uniform vec3 attenuation;
uniform float exposure;
uniform float gamma;
out vec4 fragColor;

float f(float d) {
    float c = attenuation[0] + attenuation[1] * d + attenuation[2] * d * d;
    return c > 1.0 ? 1.0 / c : 1.0;
}

void main() {
    if (!enablelighting) {
        fragColor = vec4(0.5 * normalize(normal) + 0.5, 1.0);
        return;
    }
    vec4 here = modelview * position;
    vec3 surface = here.xyz / here.w;
    vec3 n = normalize((transpose(inverse(modelview)) * vec4(normal, 0.0)).xyz);
    vec3 toEye = normalize(-surface);
    fragColor = emision;
    for (int i = 0; i < maximal_number; ++i) {
        if (i >= nlights) break;
        vec4 light = view * lightpositions[i];
        vec3 l;
        float left;
        if (light.w == 0.0) {
            l = normalize(light.xyz);
            left = attenuation.y > 0.0 || attenuation.z > 0.0 ? 0.0 : f(0.0);
        } else {
            vec3 arm = light.xyz / light.w - surface;
            l = normalize(arm);
            left = f(length(arm));
        }
        fragColor += ambient * lightcolors[i];
        float facing = dot(n, l);
        if (facing > 0.0) {
            fragColor += left * facing * diffuse * lightcolors[i];
            float shine = dot(n, normalize(toEye + l));
            if (shine > 0.0) fragColor += left * pow(shine, shininess) * specular * lightcolors[i];
        }
    }
    fragColor.r = exposure * pow(fragColor.r, gamma);
    fragColor.g = exposure * pow(fragColor.g, gamma);
    fragColor.b = exposure * pow(fragColor.b, gamma);
}
