#version 330 core
// Equally right: all of it in main, the 3x3 inverse written out, the sum cut short by continue.
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
uniform vec4 lightpositions[10];
uniform vec4 lightcolors[10];
uniform vec3 attenuation;
uniform float exposure;
uniform float gamma;
out vec4 fragColor;

void main() {
    vec3 a = vec3(modelview[0]);
    vec3 b = vec3(modelview[1]);
    vec3 c = vec3(modelview[2]);
    float volume = dot(a, cross(b, c));
    // Rows of the inverse; as columns they are its transpose.
    vec3 row0 = cross(b, c) / volume;
    vec3 row1 = cross(c, a) / volume;
    vec3 row2 = cross(a, b) / volume;
    vec3 n = row0 * normal.x + row1 * normal.y + row2 * normal.z;
    n = n / length(n);

    if (!enablelighting) {
        fragColor = vec4(n, 1.0);
        return;
    }

    vec4 p = modelview * position;
    vec3 sum = emision.rgb;
    for (int i = 0; i < 10; i++) {
        if (i >= nlights) continue;
        vec3 L = lightcolors[i].rgb;
        sum += ambient.rgb * L;

        vec4 place = view * lightpositions[i];
        vec3 l = place.xyz;
        float f = 1.0;
        if (place.w > 0.0) {
            l = place.xyz / place.w - p.xyz;
            float d = length(l);
            f = attenuation.x + attenuation.y * d + attenuation.z * d * d;
            f = f < 1.0 ? 1.0 : 1.0 / f;
        }
        l = l / length(l);
        float nl = dot(n, l);
        if (nl > 0.0) sum += f * nl * diffuse.rgb * L;

        vec3 h = l - p.xyz / length(p.xyz);
        float nh = dot(n, h) / length(h);
        if (nh <= 0.0) continue;
        sum += f * exp(shininess * log(nh)) * specular.rgb * L;
    }

    // exp and log in place of pow; the logarithm of 0 does not exist.
    vec3 mapped = vec3(0.0);
    if (sum.r > 0.0) mapped.r = exp(gamma * log(sum.r));
    if (sum.g > 0.0) mapped.g = exp(gamma * log(sum.g));
    if (sum.b > 0.0) mapped.b = exp(gamma * log(sum.b));
    fragColor = vec4(exposure * mapped, 1.0);
}
