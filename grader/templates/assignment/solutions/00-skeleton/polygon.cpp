// The corners of a polygon, chapter 0. This is the file that you hand in.
#include "polygon.h"

#include <cg/Todo.h>

#include <cmath>

// AUTHOR: the starter. Between the two comments of a region stands the blank, which lets the rest
// of the program make sense; solutions/00-skeleton/polygon.cpp has the same text outside of them.
glm::vec2 corner(const int i, const int n) {
    // BEGIN TODO(skeleton)
    const float angle = glm::radians(360.0f * float(i) / float(n));
    return glm::vec2(-std::sin(angle), std::cos(angle));
    // END TODO(skeleton)
}
