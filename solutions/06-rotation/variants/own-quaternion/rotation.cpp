// A quaternion of its own: what chapter 6 comes to at its end. No regions.
#include "rotation.h"

#include <cmath>

struct Quaternion {
    float real;
    glm::vec3 imaginary;

    Quaternion operator*(const Quaternion& other) const {
        return {real * other.real - glm::dot(imaginary, other.imaginary),
                real * other.imaginary + other.real * imaginary +
                    glm::cross(imaginary, other.imaginary)};
    }
    Quaternion conjugate() const { return {real, -imaginary}; }
};

static Quaternion turnBy(float degrees, const glm::vec3& axis) {
    const float half = glm::radians(degrees * 0.5f);
    return {std::cos(half), std::sin(half) / std::sqrt(glm::dot(axis, axis)) * axis};
}

static const glm::vec3 basis[3] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};

glm::mat3 crossMatrix(const glm::vec3 u) {
    // The imaginary part of a product of two purely imaginary quaternions is the cross product.
    glm::mat3 M(0.0f);
    for (int j = 0; j < 3; j++) {
        M[j] = (Quaternion{0.0f, u} * Quaternion{0.0f, basis[j]}).imaginary;
    }
    return M;
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    const Quaternion q = turnBy(degrees, axis);
    glm::mat3 R(0.0f);
    for (int j = 0; j < 3; j++) {
        R[j] = (q * Quaternion{0.0f, basis[j]} * q.conjugate()).imaginary;
    }
    return R;
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    // (6.15) without coordinates: (a^2 - |w|^2) I + 2 w w^T + 2 a [w x].
    const Quaternion q = turnBy(degrees, axis);
    const float a = q.real;
    const glm::vec3 w = q.imaginary;
    return glm::mat3(a * a - glm::dot(w, w)) + 2.0f * glm::outerProduct(w, w) +
           2.0f * a * crossMatrix(w);
}
