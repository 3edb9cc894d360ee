#pragma once

#include <cstdint>
#include <vector>

namespace grader {

/// An RGBA picture, 8 bits a channel, sRGB as stored; row 0 is the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    bool empty() const { return rgba.empty(); }
    const std::uint8_t* pixel(int x, int y) const {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
    bool sameSizeAs(const Picture& other) const {
        return width == other.width && height == other.height && rgba.size() == other.rgba.size();
    }
};

}  // namespace grader
