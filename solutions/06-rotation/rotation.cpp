// The cross product as a matrix, and two ways to turn a vector, chapter 6. You hand in this file.
#include "rotation.h"

#include <cg/Todo.h>

#include <cmath>

glm::mat3 crossMatrix(const glm::vec3 u) {
    // BEGIN TODO(cross-matrix)
    return glm::mat3(glm::vec3(0.0f, u.z, -u.y),   // column 0: u x e_x
                     glm::vec3(-u.z, 0.0f, u.x),   // column 1: u x e_y
                     glm::vec3(u.y, -u.x, 0.0f));  // column 2: u x e_z
    // END TODO(cross-matrix)
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(rotation)
    const float angle = glm::radians(degrees);
    const glm::vec3 a = glm::normalize(axis);
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    glm::mat3 R(0.0f);
    for (int j = 0; j < 3; ++j) {
        // Column j is the image of the basis vector e_j, eq. (6.10).
        glm::vec3 e(0.0f);
        e[j] = 1.0f;
        const glm::vec3 parallel = glm::dot(a, e) * a;
        R[j] = parallel + c * (e - parallel) + s * glm::cross(a, e);
    }
    return R;
    // END TODO(rotation)
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(euler-rodrigues)
    const float half = 0.5f * glm::radians(degrees);
    const glm::vec3 bcd = std::sin(half) * glm::normalize(axis);
    const float a = std::cos(half), b = bcd.x, c = bcd.y, d = bcd.z;
    glm::mat3 R(0.0f);
    R[0] = glm::vec3(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c));
    R[1] = glm::vec3(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b));
    R[2] = glm::vec3(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d);
    return R;
    // END TODO(euler-rodrigues)
}
