#version 330 core
// Colours a surface by its material, as if a white lamp were fixed to the camera. Uses each member
// of Material, and no light of the scene; a preview, not the lighting of chapter 10.

in vec4 position;  // model coordinates
in vec3 normal;    // model coordinates; interpolation may have changed its length

uniform mat4 modelview;
uniform vec4 ambient;
uniform vec4 diffuse;
uniform vec4 specular;
uniform vec4 emision;
uniform float shininess;

out vec4 fragColor;

void main() {
    vec3 toCamera = normalize(-(modelview * position).xyz);
    vec3 n = normalize(transpose(inverse(mat3(modelview))) * normal);
    float facing = max(dot(n, toCamera), 0.0);
    vec3 color = emision.rgb + ambient.rgb + diffuse.rgb * facing;
    if (facing > 0.0) {
        color += specular.rgb * pow(facing, shininess);
    }
    fragColor = vec4(color, 1.0);
}
