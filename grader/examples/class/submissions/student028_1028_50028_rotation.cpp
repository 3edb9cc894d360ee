// Geometry in place of formulas: a basis whose third vector is the axis, a plane rotation there,
// and back. No regions.
#include "rotation.h"

#include <array>
#include <cmath>

namespace {

// A right-handed orthonormal basis (p, q, n).
glm::mat3 frameOf(const glm::vec3& n) {
    const glm::vec3 other =
        std::abs(n.x) < 0.6f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 p = glm::normalize(glm::cross(other, n));
    return glm::mat3(p, glm::cross(n, p), n);
}

glm::mat3 aboutZ(float radians) {
    const glm::vec3 x(std::cos(radians), std::sin(radians), 0.0f);
    const glm::vec3 y(-x.y, x.x, 0.0f);
    return glm::mat3(x, y, glm::vec3(0.0f, 0.0f, 1.0f));
}

// Product of quaternions with the factor on the left, or on the right, as a matrix of four.
using Four = std::array<float, 4>;

glm::mat4 timesFromTheLeft(const Four& q) {
    const auto [a, b, c, d] = q;
    return glm::mat4(a, b, c, d, -b, a, d, -c, -c, -d, a, b, -d, c, -b, a);
}

glm::mat4 timesFromTheRight(const Four& q) {
    const auto [a, b, c, d] = q;
    return glm::mat4(a, b, c, d, -b, a, -d, c, -c, d, a, -b, -d, -c, b, a);
}

}  // namespace

glm::mat3 crossMatrix(const glm::vec3 u) {
    // A quarter turn about u of what is orthogonal to u, times the length of u.
    const float length = std::sqrt(glm::dot(u, u));
    if (length == 0.0f) {
        return glm::mat3(0.0f);
    }
    const glm::mat3 F = frameOf(u / length);
    const glm::vec3 zero(0.0f);
    return glm::mat3(length * F[1], -length * F[0], zero) * glm::transpose(F);
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    const glm::mat3 F = frameOf(glm::normalize(axis));
    return F * aboutZ(glm::radians(degrees)) * glm::inverse(F);
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    const float half = glm::radians(degrees) / 2.0f;
    const glm::vec3 w = std::sin(half) * glm::normalize(axis);
    const float a = std::cos(half);
    const glm::mat4 M = timesFromTheLeft({a, w.x, w.y, w.z}) *  //
                        timesFromTheRight({a, -w.x, -w.y, -w.z});
    glm::mat3 R;
    for (int j = 0; j < 3; ++j) {
        R[j] = glm::vec3(M[j + 1].y, M[j + 1].z, M[j + 1].w);
    }
    return R;
}
