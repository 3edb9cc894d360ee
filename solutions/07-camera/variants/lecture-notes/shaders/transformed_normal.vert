# version 330 core

layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;

uniform mat4 modelview;
uniform mat4 projection;

out vec4 position;
out vec3 normal;

void main(){
    mat3 A = mat3( modelview );
    vec3 n = transpose( inverse( A ) ) * vertex_normal;
    normal = n / length( n );
    position = vec4( vertex_position, 1.0f );
    gl_Position = projection * modelview * vec4( vertex_position, 1.0f );
}
