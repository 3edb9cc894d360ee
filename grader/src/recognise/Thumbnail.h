#pragma once

#include <cstdint>
#include <vector>

#include "compare/Picture.h"

namespace grader {

/// A frame so small that a mistake's can be stored by the hundred: mean colours of square blocks,
/// `kThumbnailWidth` of them side by side.
struct Thumbnail {
    int width = 0, height = 0;      ///< in blocks
    std::vector<std::uint8_t> rgb;  ///< row 0 is the top
};

inline constexpr int kThumbnailWidth = 20;

Thumbnail thumbnailOf(const Picture& picture);

/// Mean difference of a channel, 0 … 255; 255 when the sizes differ.
double distance(const Thumbnail& a, const Thumbnail& b);

}  // namespace grader
