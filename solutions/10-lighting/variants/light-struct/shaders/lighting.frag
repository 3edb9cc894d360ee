#version 330 core
// Equally right: a struct for the surface and one for each light as the surface sees it.
struct Surface {
    vec3 place;
    vec3 normal;
    vec3 toEye;
};

struct Lamp {
    vec3 direction;  // from the surface
    vec3 color;
    vec3 arriving;  // the colour after attenuation
};

uniform mat4 modelview;
uniform mat4 view;
uniform int nlights;
uniform bool enablelighting;
uniform vec4 lightpositions[10], lightcolors[10];
uniform vec3 attenuation = vec3(1.0, 0.0, 0.0);
uniform float exposure = 1.0, gamma = 1.0;
uniform vec4 ambient, diffuse, specular, emision;
uniform float shininess;

in vec3 normal;
in vec4 position;
out vec4 shade;

Surface surfaceHere() {
    Surface s;
    vec4 p = modelview * position;
    s.place = p.xyz / p.w;
    s.normal = normalize(normal * inverse(mat3(modelview)));
    s.toEye = normalize(-s.place);
    return s;
}

Lamp lampSeenFrom(Surface s, int index) {
    vec4 seen = view * lightpositions[index];
    Lamp lamp;
    lamp.color = lightcolors[index].rgb;
    lamp.arriving = lamp.color;
    if (lightpositions[index].w == 0.0) {
        lamp.direction = normalize(seen.xyz);
        return lamp;
    }
    vec3 gap = seen.xyz / seen.w - s.place;
    float d = length(gap);
    lamp.direction = gap / d;
    float c = dot(attenuation, vec3(1.0, d, d * d));
    lamp.arriving *= clamp(1.0 / c, 0.0, 1.0);
    return lamp;
}

float cosine(vec3 a, vec3 b) {
    return max(0.0, dot(a, b));
}

vec3 shadeBy(Lamp lamp, Surface s) {
    vec3 halfway = normalize(s.toEye + lamp.direction);
    vec3 mask = diffuse.rgb * cosine(s.normal, lamp.direction);
    mask += specular.rgb * pow(cosine(s.normal, halfway), shininess);
    return ambient.rgb * lamp.color + mask * lamp.arriving;
}

void main() {
    Surface s = surfaceHere();
    vec3 light = emision.rgb;
    int index = 0;
    while (index < nlights) {
        light += shadeBy(lampSeenFrom(s, index), s);
        ++index;
    }
    shade.rgb = enablelighting ? exposure * pow(light, vec3(gamma)) : abs(s.normal);
    shade.a = 1.0;
}
