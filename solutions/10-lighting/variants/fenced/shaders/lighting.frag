#version 330 core
// Equally right: the regions kept, each filled by other means.
//
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
uniform float shininess;  // sigma, above 1

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
    vec3 a = modelview[0].xyz, b = modelview[1].xyz, c = modelview[2].xyz;
    vec3 n = normal.x * cross(b, c) + normal.y * cross(c, a) + normal.z * cross(a, b);
    return n * inversesqrt(dot(n, n));
}
// END TODO(normals)

// BEGIN TODO(light-direction)
// Unit vector from the surface at p to a light in world coordinates, (10.22) or (10.23).
vec3 lightDirection(vec4 light, vec4 p) {
    vec3 toLight = mat3(view) * light.xyz;
    if (light.w > 0.0) {
        toLight = toLight / light.w + view[3].xyz - p.xyz;
    }
    return toLight / length(toLight);
}
// END TODO(light-direction)

// BEGIN TODO(attenuation)
// What is left of a light at the surface: f(d) of (10.14), never above 1. d is the distance between
// two points. A light at infinity may be left as it is.
float lightLeft(vec4 light, vec4 p) {
    // In world coordinates; a rigid view keeps distances.
    vec4 here = inverse(view) * p;
    if (light.w > 0.0) {
        float d = length(light.xyz / light.w - here.xyz);
        return 1.0 / max(1.0, attenuation.x + d * (attenuation.y + d * attenuation.z));
    }
    return 1.0;
}
// END TODO(attenuation)

// BEGIN TODO(ambient)
// Ambient reflection of light i, (10.4).
vec3 ambientPart(int i) {
    vec4 both = lightcolors[i];
    both *= ambient;
    return vec3(both);
}
// END TODO(ambient)

// BEGIN TODO(diffuse)
// Diffuse reflection of light i, (10.14) without f(d). l points to the light.
vec3 diffusePart(int i, vec3 n, vec3 l) {
    float cosine = dot(n, l);
    if (cosine < 0.0) {
        return vec3(0.0);
    }
    return mix(vec3(0.0), diffuse.rgb * lightcolors[i].rgb, cosine);
}
// END TODO(diffuse)

// BEGIN TODO(specular)
// Blinn-Phong reflection of light i, (10.19) without f(d). l points to the light.
vec3 specularPart(int i, vec4 p, vec3 n, vec3 l) {
    vec3 h = l - p.xyz / length(p.xyz);
    float cosine = dot(h, n) * inversesqrt(dot(h, h));
    if (cosine > 0.0 && dot(n, l) > 0.0) {
        return lightcolors[i].rgb * pow(cosine, shininess) * specular.rgb;
    }
    return vec3(0.0);
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
    vec3 total = vec3(0.0);
    for (int k = lightcolors.length() - 1; k >= 0; --k) {
        if (k >= nlights) continue;
        total = total + reflected(k, p, n);
    }
    return total;
}
// END TODO(many-lights)

// BEGIN TODO(emission)
// What the surface glows by itself, E of (10.20).
vec3 emissionPart() {
    return vec3(emision.r, emision.g, emision.b);
}
// END TODO(emission)

// BEGIN TODO(tone-mapping)
// The final colour, each channel mapped by (10.2).
vec3 toneMapped(vec3 light) {
    for (int k = 0; k < 3; ++k) {
        light[k] = light[k] > 0.0 ? exposure * exp2(gamma * log2(light[k])) : 0.0;
    }
    return light;
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
