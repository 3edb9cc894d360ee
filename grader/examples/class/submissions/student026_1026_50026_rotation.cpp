// submission 26
// Three ways to turn a vector, chapter 6. This is the file that you hand in.
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
    const float angle = degrees;
    const glm::vec3 a = glm::normalize(axis);
    const glm::mat3 cross = glm::mat3(0.0f, a.z, -a.y, -a.z, 0.0f, a.x, a.y, -a.x, 0.0f);
    return std::cos(angle) * glm::mat3(1.0f) + (1.0f - std::cos(angle)) * glm::outerProduct(a, a) +
           std::sin(angle) * cross;
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
