#pragma once

#include <cstdint>
#include <vector>

namespace cg {

constexpr int maxSide = 16384;  ///< pixels, of a picture, a framebuffer or a window

/// A picture in memory. Row 0 is the top; within a row from left to right; 4 bytes a pixel in the
/// order red, green, blue, alpha, sRGB as stored in a file or framebuffer.
/// rgba.size() is 4 * width * height.
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
    /// 1 for each pixel that a file of floats holds no number for; empty when there is none.
    std::vector<std::uint8_t> broken;
};

}  // namespace cg
