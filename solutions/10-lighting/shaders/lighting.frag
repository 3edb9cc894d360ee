#version 330 core
// Blinn-Phong shading of one fragment (sections 10.3 and 10.4). You hand this file in.
//
// Everything here happens in camera coordinates: the surface is at p, its unit normal is n, and the
// camera sits at the origin. Positions and directions of lights come in world coordinates.

in vec4 position;  // model coordinates, w = 1
in vec3 normal;    // model coordinates; interpolation may have changed its length

uniform mat4 view;       // world to camera coordinates
uniform mat4 modelview;  // model to camera coordinates

uniform vec4 ambient;     // C_ambient; of all colours only the rgb count
uniform vec4 diffuse;     // C_diffuse
uniform vec4 specular;    // C_specular
uniform vec4 emision;     // E, spelled as in the notes
uniform float shininess;  // sigma, above 0

uniform bool enablelighting;      // false: show the normals instead
uniform int nlights;              // 0 to 10; what later slots hold means nothing
uniform vec4 lightpositions[10];  // world coordinates; w = 0: a light at infinity
uniform vec4 lightcolors[10];     // L

uniform vec3 attenuation;  // c0, c1, c2 of (10.14)
uniform float exposure;    // A of (10.2)
uniform float gamma;       // of (10.2)

out vec4 fragColor;

// BEGIN TODO(normals)
// The surface's unit normal in camera coordinates, (7.41).
vec3 surfaceNormal() {
    return normalize(transpose(inverse(mat3(modelview))) * normal);
}
// END TODO(normals)

// BEGIN TODO(light-direction)
// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec4 place = view * light;
    return normalize(p.w * place.xyz - place.w * p.xyz);
}
// END TODO(light-direction)

// BEGIN TODO(attenuation)
// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    if (light.w == 0.0) return 1.0;
    vec4 place = view * light;
    float d = distance(place.xyz / place.w, p.xyz / p.w);
    return min(1.0 / (attenuation.x + attenuation.y * d + attenuation.z * d * d), 1.0);
}
// END TODO(attenuation)

// BEGIN TODO(ambient)
// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    return ambient.rgb * lightcolors[i].rgb;
}
// END TODO(ambient)

// BEGIN TODO(diffuse)
// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    return diffuse.rgb * max(dot(n, l), 0.0) * lightcolors[i].rgb;
}
// END TODO(diffuse)

// BEGIN TODO(specular)
// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 v = normalize(-p.xyz);
    vec3 h = normalize(v + l);
    return specular.rgb * pow(max(dot(n, h), 0.0), shininess) * lightcolors[i].rgb;
}
// END TODO(specular)

// What the surface reflects of light i: one term of the sum (10.20).
vec3 reflected(int i, vec4 p, vec3 n) {
    vec3 l = lightDirection(lightpositions[i], p);
    float left = lightLeft(lightpositions[i], p);
    return ambientPart(i) + left * (diffusePart(i, n, l) + specularPart(i, p, n, l));
}

// BEGIN TODO(many-lights)
// What the surface reflects of all lights, the sum of (10.20). Until then, of the first one.
vec3 allReflected(vec4 p, vec3 n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < nlights; ++i) {
        sum += reflected(i, p, n);
    }
    return sum;
}
// END TODO(many-lights)

// BEGIN TODO(emission)
// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    return emision.rgb;
}
// END TODO(emission)

// BEGIN TODO(tone-mapping)
// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    return exposure * pow(light, vec3(gamma));
}
// END TODO(tone-mapping)

void main() {
    vec4 p = modelview * position;
    vec3 n = surfaceNormal();
    if (enablelighting) {
        fragColor = vec4(toneMapped(emissionPart() + allReflected(p, n)), 1.0);
    } else {
        fragColor = vec4(0.5 * normalize(n) + 0.5, 1.0);
    }
}
