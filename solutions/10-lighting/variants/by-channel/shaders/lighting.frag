#version 330
// Equally right: arrays and loops over channels, no vector functions but length; out parameters.
#define CHANNELS 3
#define MAX_LIGHTS 10

in vec4 position;
in vec3 normal;

uniform mat4 view;
uniform mat4 modelview;
uniform vec4 ambient;
uniform vec4 diffuse;
uniform vec4 specular;
uniform vec4 emision;
uniform float shininess;
uniform bool enablelighting;
uniform int nlights;
uniform vec4 lightpositions[MAX_LIGHTS];
uniform vec4 lightcolors[MAX_LIGHTS];
uniform vec3 attenuation;
uniform float exposure;
uniform float gamma;

layout(location = 0) out vec4 result;

float product(vec3 a, vec3 b) {
    float sum = 0.0;
    for (int k = 0; k < CHANNELS; ++k) sum += a[k] * b[k];
    return sum;
}

// Solves transpose(M) n = normal by Cramer's rule.
vec3 upright() {
    float m[9];
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) m[3 * column + row] = modelview[column][row];
    vec3 n;
    for (int k = 0; k < 3; ++k) {
        int r = (k + 1) % 3, s = (k + 2) % 3;
        float minor0 = m[3 + r] * m[6 + s] - m[3 + s] * m[6 + r];
        float minor1 = m[6 + r] * m[s] - m[6 + s] * m[r];
        float minor2 = m[r] * m[3 + s] - m[s] * m[3 + r];
        n[k] = minor0 * normal.x + minor1 * normal.y + minor2 * normal.z;
    }
    return n / length(n);
}

void aim(in vec4 lamp, in vec3 from, out vec3 l, out float d) {
    l = lamp.xyz;
    d = 0.0;
    if (lamp.w != 0.0) {
        l = l / lamp.w - from;
        d = length(l);
    }
    l /= length(l);
}

void main() {
    vec3 here = (modelview * position).xyz;
    vec3 n = upright();
    vec3 v = -here / length(here);
    vec3 total = vec3(0.0);
    for (int i = 0; i < nlights && enablelighting; ++i) {
        vec3 l;
        float d;
        aim(view * lightpositions[i], here, l, d);
        float c = attenuation.x + attenuation.y * d + attenuation.z * d * d;
        float f = lightpositions[i].w > 0.0 && c > 1.0 ? 1.0 / c : 1.0;
        vec3 h = v + l;
        h /= length(h);
        float matt = clamp(product(n, l), 0.0, 1.0);
        float shiny = pow(clamp(product(n, h), 0.0, 1.0), shininess);
        for (int k = 0; k < CHANNELS; ++k) {
            float back = ambient[k] + f * (diffuse[k] * matt + specular[k] * shiny);
            total[k] += back * lightcolors[i][k];
        }
    }
    for (int k = 0; k < CHANNELS; ++k) {
        result[k] = exposure * pow(total[k] + emision[k], gamma);
        if (!enablelighting) result[k] = abs(n[k]);
    }
    result.a = 1.0;
}
