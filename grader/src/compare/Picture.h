#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace grader {

using Rgb = std::array<std::uint8_t, 3>;

/// An RGBA picture, 8 bits a channel, sRGB as stored; row 0 is the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    /// Pixels (row * width + column) that a file of floats holds no number for; mostly empty.
    std::vector<std::size_t> broken;

    bool empty() const { return rgba.empty(); }
    const std::uint8_t* pixel(int x, int y) const {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
    std::uint8_t* pixel(int x, int y) {
        return const_cast<std::uint8_t*>(static_cast<const Picture&>(*this).pixel(x, y));
    }
    bool sameSizeAs(const Picture& other) const {
        return width == other.width && height == other.height && rgba.size() == other.rgba.size();
    }
};

/// A picture of one colour, as large as another.
Picture flatPicture(const Picture& like, const Rgb& colour);

Rgb meanColour(const Picture& picture);

/// In nearly every scene the colour that the background is cleared with.
Rgb mostFrequentColour(const Picture& picture);

}  // namespace grader
