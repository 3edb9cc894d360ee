// Right products of complex numbers, computed in the judge.
#pragma once

#include <complex>

#include "levels.h"

namespace products {

inline glm::vec2 product(const glm::vec2& a, const glm::vec2& b) {
    const auto result = std::complex<double>(a.x, a.y) * std::complex<double>(b.x, b.y);
    return {float(result.real()), float(result.imag())};
}

/// Compares cprod(a[i], b[i]) with the right products and returns the student's. Without such a
/// function nothing is returned, and I(c) over a part of the plane is judged instead.
inline std::optional<std::vector<glm::vec2>> expectProducts(const std::vector<glm::vec2>& a,
                                                            const std::vector<glm::vec2>& b) {
    const auto got = levels::valuesOf<std::vector<glm::vec2>>("cprod", a, b);
    if (!got) {
        levels::expectIndices({{0.16f, 0.98f}, {-0.12f, -1.13f}, {-1.37f, 0.22f}, {0.42f, -0.4f}},
                              50, course::crown);
        return got;
    }
    judge::needCount("cprod", got->size(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        judge::expectClose(judge::say("cprod(a, b) for a = {}, b = {}", a[i], b[i]), got->at(i),
                           product(a[i], b[i]));
    return got;
}

}  // namespace products
