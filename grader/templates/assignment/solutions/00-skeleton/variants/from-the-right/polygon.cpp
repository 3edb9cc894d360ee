// From the right, as angles usually are, and a quarter of a turn ahead.
#include "polygon.h"

#include <cmath>

glm::vec2 corner(const int i, const int n) {
    const float angle = glm::radians(360.0f * float(i) / float(n) + 90.0f);
    return {std::cos(angle), std::sin(angle)};
}
