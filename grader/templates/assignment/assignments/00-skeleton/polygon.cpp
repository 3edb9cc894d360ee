// The corners of a polygon, chapter 0. This is the file that you hand in.
#include "polygon.h"

#include <cg/Todo.h>

#include <cmath>

// AUTHOR: the starter. Between the two comments of a region stands the blank, which lets the rest
// of the program make sense; solutions/00-skeleton/polygon.cpp has the same text outside of them.
glm::vec2 corner(const int i, const int n) {
    // BEGIN TODO(skeleton)
    // Return corner i of n: corner 0 is (0, 1), the next ones follow counter-clockwise.
    (void)i;  // delete these two lines, too
    (void)n;
    return cg::todo<glm::vec2>("skeleton", glm::vec2(0.0f));
    // END TODO(skeleton)
}
