// The top, turned by a matrix. GLM stores columns.
#include "polygon.h"

#include <cmath>

glm::vec2 corner(const int i, const int n) {
    const float angle = glm::radians(360.0f) * float(i) / float(n);
    const float c = std::cos(angle), s = std::sin(angle);
    const glm::mat2 turn(c, s, -s, c);
    return turn * glm::vec2(0.0f, 1.0f);
}
