// The right corners, computed in the judge, and the sentence shared by its tests.
#pragma once

#include <subject/Judge.h>

#include <numbers>

namespace truth {

inline glm::vec2 corner(int i, int n) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    return glm::vec2(glm::dvec2(-std::sin(angle), std::cos(angle)));
}

inline void expectCorner(int i, int n) {
    judge::expectClose(judge::say("corner({}, {})", i, n),
                       judge::subject().call<glm::vec2>("corner", i, n), corner(i, n));
}

}  // namespace truth
