// From the corner before, by the addition theorems.
#include "polygon.h"

#include <cmath>

glm::vec2 corner(const int i, const int n) {
    if (i == 0) {
        return glm::vec2(0.0f, 1.0f);
    }
    const glm::vec2 before = corner(i - 1, n);
    const float step = glm::radians(360.0f / float(n));
    return before * std::cos(step) + glm::vec2(-before.y, before.x) * std::sin(step);
}
