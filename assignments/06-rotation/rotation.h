// Rotation matrices (chapter 6). Provided; it is not handed in.
//
// A matrix acts on columns, v' = R v, and GLM stores it column by column: the entry in row i and
// column j of the notes is M[j][i], and M[j] is the j-th column.
#pragma once

#include <glm/glm.hpp>

/// The matrix [u x] with [u x] v = u x v for every v, eq. (6.7). Any u, of any length.
glm::mat3 crossMatrix(const glm::vec3 u);

/// The rotation by `degrees` about `axis`, counter-clockwise when the axis points at the reader,
/// eq. (6.13). Any angle; the axis may have any length but 0 and is normalised by the function.
glm::mat3 rotation(const float degrees, const glm::vec3 axis);

/// The same rotation from the four numbers a, b, c, d of eq. (6.14) and the matrix of eq. (6.15).
glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis);
