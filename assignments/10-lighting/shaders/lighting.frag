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
uniform float cg_todo_normals;  // delete this line, too
vec3 surfaceNormal() {
    return normal + cg_todo_normals;
}
// END TODO(normals)

// BEGIN TODO(light-direction)
// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
uniform float cg_todo_light_direction;
vec3 lightDirection(vec4 light, vec4 p) {
    return normalize(light.xyz) + cg_todo_light_direction;
}
// END TODO(light-direction)

// BEGIN TODO(attenuation)
// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
uniform float cg_todo_attenuation;
float lightLeft(vec4 light, vec4 p) {
    return 1.0 + cg_todo_attenuation;
}
// END TODO(attenuation)

// BEGIN TODO(ambient)
// Ambient reflection of light i, (10.4).
uniform float cg_todo_ambient;
vec3 ambientPart(int i) {
    return vec3(cg_todo_ambient);
}
// END TODO(ambient)

// BEGIN TODO(diffuse)
// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
uniform float cg_todo_diffuse;
vec3 diffusePart(int i, vec3 n, vec3 l) {
    return vec3(cg_todo_diffuse) * dot(n, l);
}
// END TODO(diffuse)

// BEGIN TODO(specular)
// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
uniform float cg_todo_specular;
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    return vec3(cg_todo_specular) * dot(n, l);
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
uniform float cg_todo_many_lights;
vec3 allReflected(vec4 p, vec3 n) {
    return reflected(0, p, n) + cg_todo_many_lights;
}
// END TODO(many-lights)

// BEGIN TODO(emission)
// What the surface glows by itself, E of (10.20).
uniform float cg_todo_emission;
vec3 emissionPart() {
    return vec3(cg_todo_emission);
}
// END TODO(emission)

// BEGIN TODO(tone-mapping)
// The final colour, each channel mapped by (10.2).
uniform float cg_todo_tone_mapping;
vec3 toneMapped(vec3 light) {
    return light + cg_todo_tone_mapping;
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
