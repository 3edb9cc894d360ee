#pragma once

#include <glm/glm.hpp>

// AUTHOR: what the student's file defines, and the window, the harness and the tests rely on.

/// Corner i of the regular polygon of n corners on the circle of radius 1 about the origin: corner
/// 0 is on top, (0, 1), and the next ones follow counter-clockwise. n is at least 3, 0 <= i < n.
glm::vec2 corner(const int i, const int n);
