// The cross product as a matrix, and two ways to turn a vector, chapter 6. You hand in this file.
#include "rotation.h"

#include <cg/Todo.h>

#include <cmath>

glm::mat3 crossMatrix(const glm::vec3 u) {
    // BEGIN TODO(cross-matrix)
    // As (6.7) is printed, row by row; transpose makes columns of it.
    return glm::transpose(glm::mat3(0.0f, -u.z, u.y,  //
                                    u.z, 0.0f, -u.x,  //
                                    -u.y, u.x, 0.0f));
    // END TODO(cross-matrix)
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(rotation)
    // The nine entries of (6.13), multiplied out.
    const glm::vec3 n = glm::normalize(axis);
    const float x = n.x, y = n.y, z = n.z;
    const float s = std::sin(glm::radians(degrees));
    const float c = std::cos(glm::radians(degrees));
    const float v = 1.0f - c;
    return glm::transpose(glm::mat3(v * x * x + c, v * x * y - s * z, v * x * z + s * y,  //
                                    v * x * y + s * z, v * y * y + c, v * y * z - s * x,  //
                                    v * x * z - s * y, v * y * z + s * x, v * z * z + c));
    // END TODO(rotation)
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(euler-rodrigues)
    // On the diagonal a^2 + b^2 + c^2 + d^2 = 1 saves two of the four squares.
    const glm::vec3 n = glm::normalize(axis);
    const float t = glm::radians(degrees) / 2.0f;
    const float a = std::cos(t), b = std::sin(t) * n.x, c = std::sin(t) * n.y,
                d = std::sin(t) * n.z;
    const glm::vec3 row1(1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c));
    const glm::vec3 row2(2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b));
    const glm::vec3 row3(2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c));
    return glm::transpose(glm::mat3(row1, row2, row3));
    // END TODO(euler-rodrigues)
}
