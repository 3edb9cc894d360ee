// The cross product as a matrix, and two ways to turn a vector, chapter 6. You hand in this file.
#include "rotation.h"

#include <cg/Todo.h>

#include <cmath>

glm::mat3 crossMatrix(const glm::vec3 u) {
    // BEGIN TODO(cross-matrix)
    // Return the matrix of eq. (6.7). Row i, column j of the notes is M[j][i] here.
    (void)u;  // delete this line, too
    return cg::todo<glm::mat3>("cross-matrix", glm::mat3(0.0f));
    // END TODO(cross-matrix)
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(rotation)
    // Return the matrix of eq. (6.13). The angle comes in degrees, the axis with any length.
    (void)degrees;
    (void)axis;
    return cg::todo<glm::mat3>("rotation", glm::mat3(1.0f));
    // END TODO(rotation)
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(euler-rodrigues)
    // Compute a, b, c, d of eq. (6.14), then return the matrix of eq. (6.15).
    (void)degrees;
    (void)axis;
    return cg::todo<glm::mat3>("euler-rodrigues", glm::mat3(1.0f));
    // END TODO(euler-rodrigues)
}
