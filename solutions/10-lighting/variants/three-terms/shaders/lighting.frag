#version 330 core
// Equally right: one function gives all three terms as the columns of a matrix, the half vector is
// never made, and each channel is mapped by a function of its own.
in vec4 position;
in vec3 normal;

uniform mat4 view, modelview;
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

// How much of a light the surface sends back: ambient, diffuse, specular.
vec3 shares(vec3 n, vec3 v, vec3 l, float f) {
    float nl = dot(n, l), nv = dot(n, v), vl = dot(v, l);
    // |v + l|^2 = 2 + 2 v.l
    float nh = (nv + nl) * inversesqrt(max(2.0 + 2.0 * vl, 1e-12));
    return vec3(1.0, f * max(nl, 0.0), f * (nh > 0.0 ? pow(nh, shininess) : 0.0));
}

mat3 terms(vec3 n, vec3 v, vec4 lamp, vec3 color, vec3 place) {
    vec3 arm = lamp.xyz - lamp.w * place;
    float reach = length(arm);
    float f = 1.0;
    if (lamp.w > 0.0) {
        float d = reach / lamp.w;
        f = min(1.0 / (attenuation[0] + d * (attenuation[1] + d * attenuation[2])), 1.0);
    }
    return outerProduct(color, shares(n, v, arm / reach, f));
}

float mapped(float channel) {
    return exposure * pow(channel, gamma);
}

void main() {
    vec3 place = (modelview * position).xyz;
    vec3 v = place * -inversesqrt(dot(place, place));
    mat4 back = inverse(modelview);
    vec3 n = normalize(vec3(dot(back[0].xyz, normal), dot(back[1].xyz, normal),
                            dot(back[2].xyz, normal)));
    if (!enablelighting) {
        fragColor = vec4(0.5 + 0.5 * n, 1.0);
    } else {
        mat3 sum = mat3(0.0);
        for (int i = 0; i != nlights; ++i) {
            sum += terms(n, v, view * lightpositions[i], lightcolors[i].rgb, place);
        }
        vec3 light = emision.rgb;
        light += sum[0] * ambient.rgb;
        light += sum[1] * diffuse.rgb;
        light += sum[2] * specular.rgb;
        fragColor = vec4(mapped(light.r), mapped(light.g), mapped(light.b), 0.0);
    }
}
