// The cross product as a matrix, and two ways to turn a vector, chapter 6. You hand in this file.
#include "rotation.h"

#include <cg/Todo.h>

#include <cmath>

glm::mat3 crossMatrix(const glm::vec3 u) {
    // BEGIN TODO(cross-matrix)
    // u x v is linear in u, too: a sum over the three infinitesimal turns.
    const glm::mat3 aboutX(0, 0, 0, 0, 0, 1, 0, -1, 0);
    const glm::mat3 aboutY(0, 0, -1, 0, 0, 0, 1, 0, 0);
    const glm::mat3 aboutZ(0, 1, 0, -1, 0, 0, 0, 0, 0);
    return u.x * aboutX + u.y * aboutY + u.z * aboutZ;
    // END TODO(cross-matrix)
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(rotation)
    // The series of exp(angle [a x]). Whole turns go first: small terms lose no digits.
    const double angle = glm::radians(std::remainder(double(degrees), 360.0));
    const glm::dmat3 K = angle * glm::dmat3(crossMatrix(glm::normalize(axis)));
    glm::dmat3 sum(1.0), term(1.0);
    for (int n = 1; n < 30; ++n) {
        term = term * K / double(n);
        sum += term;
    }
    return glm::mat3(sum);
    // END TODO(rotation)
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(euler-rodrigues)
    // v + 2 a (w x v) + 2 w x (w x v), with w = (b, c, d), written with matrices.
    const float half = glm::radians(degrees) * 0.5f;
    const float sine = std::sin(half), a = std::cos(half);
    const glm::mat3 W = crossMatrix(sine * axis * glm::inversesqrt(glm::dot(axis, axis)));
    return glm::mat3(1.0f) + 2.0f * a * W + 2.0f * W * W;
    // END TODO(euler-rodrigues)
}
