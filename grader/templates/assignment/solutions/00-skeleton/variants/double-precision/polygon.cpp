// In double precision, rounded once.
#include "polygon.h"

#include <cmath>

glm::vec2 corner(const int i, const int n) {
    const double angle = 2.0 * std::acos(-1.0) * i / n;
    return glm::vec2(float(-std::sin(angle)), float(std::cos(angle)));
}
