#include "recognise/Thumbnail.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace grader {

Thumbnail thumbnailOf(const Picture& picture) {
    if (picture.empty())
        return {};
    const int block = std::max(1, (picture.width + kThumbnailWidth - 1) / kThumbnailWidth);
    Thumbnail thumbnail{
        (picture.width + block - 1) / block, (picture.height + block - 1) / block, {}};
    for (int by = 0; by < thumbnail.height; ++by)
        for (int bx = 0; bx < thumbnail.width; ++bx) {
            double sum[3] = {};
            int pixels = 0;
            for (int y = by * block; y < std::min(picture.height, (by + 1) * block); ++y)
                for (int x = bx * block; x < std::min(picture.width, (bx + 1) * block); ++x) {
                    for (int c = 0; c < 3; ++c)
                        sum[c] += picture.pixel(x, y)[c];
                    ++pixels;
                }
            for (const double each : sum)
                thumbnail.rgb.push_back(static_cast<std::uint8_t>(std::lround(each / pixels)));
        }
    return thumbnail;
}

double distance(const Thumbnail& a, const Thumbnail& b) {
    if (a.width != b.width || a.height != b.height || a.rgb.empty())
        return 255.0;
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::abs(a.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(a.rgb.size());
}

}  // namespace grader
