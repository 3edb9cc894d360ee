// The right matrices of this chapter, computed in the judge, and the sentences shared by its tests.
#pragma once

#include <subject/Judge.h>

#include <glm/gtc/matrix_transform.hpp>

namespace truth {

// Axes of length 1 with three different components.
inline const glm::vec3 unitAxis = glm::vec3(2.0f, 3.0f, 6.0f) / 7.0f;
inline const glm::vec3 otherUnitAxis = glm::vec3(-4.0f, 8.0f, 1.0f) / 9.0f;

inline glm::mat3 crossMatrix(const glm::vec3& u) {
    return glm::mat3(glm::cross(u, glm::vec3(1, 0, 0)), glm::cross(u, glm::vec3(0, 1, 0)),
                     glm::cross(u, glm::vec3(0, 0, 1)));
}

inline glm::mat3 rotation(float degrees, const glm::vec3& axis) {
    const glm::dvec3 unit = glm::normalize(glm::dvec3(axis));
    return glm::mat3(glm::rotate(glm::dmat4(1.0), glm::radians(double(degrees)), unit));
}

/// Angle of a rotation, 0 to 180 degrees, from its trace 1 + 2 cos(angle).
inline float angleDegrees(const glm::mat3& R) {
    const float cosine = 0.5f * (R[0][0] + R[1][1] + R[2][2] - 1.0f);
    return glm::degrees(std::acos(glm::clamp(cosine, -1.0f, 1.0f)));
}

/// Calls the student's `function` ("rotation" or "eulerRodrigues"), compares the matrix with the
/// truth, and returns it.
inline glm::mat3 expectRotation(const std::string& function, float degrees, const glm::vec3& axis) {
    const auto R = judge::subject().call<glm::mat3>(function, degrees, axis);
    judge::expectClose(judge::say("{}({}, {})", function, degrees, axis), R,
                       rotation(degrees, axis));
    return R;
}

}  // namespace truth
