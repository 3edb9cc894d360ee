#version 330 core
// Equally right: everything in world coordinates, the camera's place taken from view.
in vec3 normal;
in vec4 position;

uniform mat4 modelview, view;
uniform vec4 ambient, diffuse, specular, emision;
uniform float shininess;
uniform vec4 lightcolors[10];
uniform vec4 lightpositions[10];
uniform int nlights;
uniform bool enablelighting;
uniform vec3 attenuation;
uniform float gamma, exposure;

layout (location = 0) out vec4 color;

void main() {
    mat4 world = inverse(view);
    mat4 model = world * modelview;
    vec3 place = (model * position).xyz;
    vec3 n = normalize(inverse(transpose(mat3(model))) * normal);
    vec3 v = normalize(world[3].xyz - place);
    vec3 total = vec3(0.0);
    for (int k = nlights - 1; k >= 0; k--) {
        vec4 light = lightpositions[k];
        vec3 arm = light.xyz - light.w * place;
        vec3 l = normalize(arm);
        float weak = 1.0;
        if (light.w != 0.0) {
            float d = length(arm) / light.w;
            weak = 1.0 / max(dot(attenuation, vec3(1.0, d, d * d)), 1.0);
        }
        float cosine = clamp(dot(n, l), 0.0, 1.0);
        float shine = pow(max(0.0, dot(normalize(l + v), n)), shininess);
        vec4 part = weak * (shine * specular + cosine * diffuse) + ambient;
        total += (part * lightcolors[k]).rgb;
    }
    color = vec4(exposure * pow(total + emision.rgb, vec3(gamma)), 0.25);
}
