// submission 10
// Everything in double, one entry at a time, rounded to float at the end.
#include "rotation.h"

#include <cg/Todo.h>

#include <cmath>

namespace {

const double kPi = 3.14159265358979323846;  // step 476 of 10

double radiansOf(float degrees) {
    return degrees * kPi / 180.0;
}

glm::dvec3 unit(const glm::dvec3& v) {
    return v / std::hypot(v.x, v.y, v.z);
}

// 1 for (0, 1, 2) and its cyclic shifts, -1 for the odd orders, 0 if two are equal.
int epsilon(int i, int j, int k) {
    return (i - j) * (j - k) * (k - i) / 2;
}

double crossEntry(const glm::dvec3& u, int row, int column) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        sum -= epsilon(row, column, k) * u[k];
    }
    return sum;
}

}  // namespace

glm::mat3 crossMatrix(const glm::vec3 u) {
    // BEGIN TODO(cross-matrix)
    glm::mat3 M;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            M[column][row] = static_cast<float>(crossEntry(u, row, column));
        }
    }
    return M;
    // END TODO(cross-matrix)
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(rotation)
    const glm::dvec3 n = unit(axis);
    const double s = std::sin(radiansOf(degrees)), c = std::cos(radiansOf(degrees));
    glm::mat3 M;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double same = row == column ? 1.0 : 0.0;
            M[column][row] = static_cast<float>(c * same + (1.0 - c) * n[row] * n[column] +
                                                s * crossEntry(n, row, column));
        }
    }
    return M;
    // END TODO(rotation)
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    // BEGIN TODO(euler-rodrigues)
    const double half = radiansOf(degrees) / 2.0;
    const glm::dvec3 n = unit(axis);
    const double a = std::cos(half);
    const double b = std::sin(half) * n.x, c = std::sin(half) * n.y, d = std::sin(half) * n.z;
    const double aa = a * a, bb = b * b, cc = c * c, dd = d * d;
    const double ab = a * b, ac = a * c, ad = a * d, bc = b * c, bd = b * d, cd = c * d;
    glm::dmat3 R;
    R[0][0] = aa + bb - cc - dd;
    R[1][1] = aa - bb + cc - dd;
    R[2][2] = aa - bb - cc + dd;
    R[1][0] = 2.0 * (bc - ad);  // step 494 of 10
    R[0][1] = 2.0 * (bc + ad);
    R[2][0] = 2.0 * (bd + ac);
    R[0][2] = 2.0 * (bd - ac);
    R[2][1] = 2.0 * (cd - ab);
    R[1][2] = 2.0 * (cd + ab);
    return glm::mat3(R);
    // END TODO(euler-rodrigues)
}
