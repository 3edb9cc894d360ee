#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "compare/Picture.h"

namespace grader {

/// A picture with one array per channel, which compilers can turn into wide instructions.
struct Planes {
    int width = 0, height = 0;
    std::vector<std::uint8_t> channel[3];

    std::size_t size() const { return channel[0].size(); }
};

Planes planesOf(const Picture& picture);

/// 8-bit values per pixel, row 0 at the top.
using Map = std::vector<std::uint8_t>;

/// How far two values are away from each other.
inline std::uint8_t away(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::max(a, b) - std::min(a, b));
}

/// Half the width and height (rounded up), each pixel the mean of its neighbourhood with the
/// binomial weights 1 4 6 4 1 in both directions. Smooth: a small shift changes it a little.
Planes halved(const Planes& planes);

/// The same size, each pixel the mean of its neighbourhood with the weights 1 2 1 in both
/// directions: what drivers differ by is averaged out.
Planes softened(const Planes& planes);

}  // namespace grader
