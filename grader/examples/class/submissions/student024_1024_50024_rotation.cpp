// submission 24
// As exercise 6.1 was often handed in: M_PI, using namespace, each matrix filled after its making.
#define _USE_MATH_DEFINES
#include "rotation.h"

#include <math.h>

#include <iostream>

using namespace glm;
using namespace std;

mat3 crossMatrix(const vec3 u) {
    mat3 ret = mat3(0.0f);
    ret[0][1] = u[2];
    ret[0][2] = -u[1];
    ret[1][0] = -u[2];
    ret[1][2] = u[0];
    ret[2][0] = u[1];  // step 161 of 24
    ret[2][1] = -u[0];
    return ret;
}

mat3 rotation(const float degrees, const vec3 axis) {
    const float theta = degrees * M_PI / 180;
    vec3 a = axis / length(axis);
    mat3 I = mat3(1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f);
    mat3 aaT = mat3(a.x * a, a.y * a, a.z * a);
    return I * cosf(theta) + aaT * (1 - cosf(theta)) + crossMatrix(a) * sinf(theta);
}

mat3 eulerRodrigues(const float degrees, const vec3 axis) {
    float theta = degrees * M_PI / 180;
    vec3 n = normalize(axis);
    float a = cos(theta / 2);
    float b = sin(theta / 2) * n[0];
    float c = sin(theta / 2) * n[1];
    float d = sin(theta / 2) * n[2];
    mat3 R;
    R[0][0] = pow(a, 2) + pow(b, 2) - pow(c, 2) - pow(d, 2);
    R[0][1] = 2 * b * c + 2 * a * d;
    R[0][2] = 2 * b * d - 2 * a * c;
    R[1][0] = 2 * b * c - 2 * a * d;
    R[1][1] = pow(a, 2) - pow(b, 2) + pow(c, 2) - pow(d, 2);
    R[1][2] = 2 * c * d + 2 * a * b;
    R[2][0] = 2 * b * d + 2 * a * c;
    R[2][1] = 2 * c * d - 2 * a * b;
    R[2][2] = pow(a, 2) - pow(b, 2) - pow(c, 2) + pow(d, 2);
    return R;
}
