#include "compare/Picture.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace grader {

Picture flatPicture(const Picture& like, const Rgb& colour) {
    Picture picture{like.width, like.height, std::vector<std::uint8_t>(like.rgba.size(), 255), {}};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        std::copy(colour.begin(), colour.end(),
                  picture.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    return picture;
}

Rgb meanColour(const Picture& picture) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += picture.rgba[i + c];
    const double pixels = static_cast<double>(picture.rgba.size()) / 4;
    Rgb mean{};
    for (std::size_t c = 0; c < 3 && pixels > 0; ++c)
        mean[c] = static_cast<std::uint8_t>(std::lround(sum[c] / pixels));
    return mean;
}

Rgb mostFrequentColour(const Picture& picture) {
    std::unordered_map<std::uint32_t, int> count;
    std::uint32_t most = 0;
    int pixels = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        const std::uint32_t colour = static_cast<std::uint32_t>(picture.rgba[i]) << 16 |
                                     static_cast<std::uint32_t>(picture.rgba[i + 1]) << 8 |
                                     picture.rgba[i + 2];
        if (const int seen = ++count[colour]; seen > pixels) {
            pixels = seen;
            most = colour;
        }
    }
    return {static_cast<std::uint8_t>(most >> 16), static_cast<std::uint8_t>(most >> 8),
            static_cast<std::uint8_t>(most)};
}

}  // namespace grader
