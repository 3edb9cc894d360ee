#version 330 core
// Written before attenuation and tone mapping were asked for: it loses their tasks and no other.
in vec4 position; // raw position in the model coord
in vec3 normal;   // raw normal in the model coord
uniform mat4 modelview; // from model coord to eye coord
uniform mat4 view;      // from world coord to eye coord
uniform vec4 ambient;
uniform vec4 diffuse;
uniform vec4 specular;
uniform vec4 emision;
uniform float shininess;
uniform bool enablelighting;
uniform int nlights;
uniform vec4 lightpositions[ 10 ];
uniform vec4 lightcolors[ 10 ];
out vec4 fragColor;

void main (void){
    vec4 pos = modelview * position;
    mat3 A = mat3(modelview[0].xyz, modelview[1].xyz, modelview[2].xyz);
    // The cofactor matrix: a positive multiple of the inverse transpose.
    mat3 C = mat3(cross(A[1], A[2]), cross(A[2], A[0]), cross(A[0], A[1]));
    vec3 n = normalize(C * normal);
    vec3 v = -normalize(pos.xyz / pos.w);
    vec4 R = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    for (int j = 0; j < nlights; j++){
        vec4 q = view * lightpositions[j];
        vec3 l = normalize(pos.w * q.xyz - q.w * pos.xyz);
        vec3 h = normalize(v + l);
        R += lightcolors[j] * (ambient + (diffuse * max(dot(n, l), 0.0f)
             + specular * pow(max(dot(n, h), 0.0f), shininess)));
    }
    R += emision;
    fragColor = R;
}
