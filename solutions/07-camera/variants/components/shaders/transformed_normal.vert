#version 330 core
layout (location = 0) in vec3 vertex_position;
layout (location = 1) in vec3 vertex_normal;
uniform mat4 modelview;
uniform mat4 projection;
out vec4 position;
out vec3 normal;

// Solves transpose(A) * n = vertex_normal by Cramer's rule.
vec3 transformedNormal() {
    mat3 T = transpose(mat3(modelview));
    float d = determinant(T);
    mat3 first = T, second = T, third = T;
    first[0] = vertex_normal;
    second[1] = vertex_normal;
    third[2] = vertex_normal;
    float x = determinant(first) / d;
    float y = determinant(second) / d;
    float z = determinant(third) / d;
    float size = sqrt(x * x + y * y + z * z);
    return vec3(x / size, y / size, z / size);
}

void main() {
    position.x = vertex_position.x;
    position.y = vertex_position.y;
    position.z = vertex_position.z;
    position.w = 1.0;
    normal = transformedNormal();
    gl_Position = projection * (modelview * position);
}
