#include "compare/Planes.h"

#include <algorithm>

namespace grader {

namespace {

constexpr int kWeights[5] = {1, 4, 6, 4, 1};

/// Rows halved: from w columns to (w + 1) / 2.
Map halvedAlongX(const Map& from, int width, int height) {
    const int half = (width + 1) / 2;
    Map to(static_cast<std::size_t>(half) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* row = from.data() + static_cast<std::ptrdiff_t>(y) * width;
        std::uint8_t* out = to.data() + static_cast<std::ptrdiff_t>(y) * half;
        for (int x = 0; x < half; ++x) {
            int sum = 8;  // rounds
            if (2 * x >= 2 && 2 * x + 2 < width) {
                const std::uint8_t* at = row + 2 * x;
                sum += at[-2] + 4 * at[-1] + 6 * at[0] + 4 * at[1] + at[2];
            } else {
                for (int k = -2; k <= 2; ++k)
                    sum += kWeights[k + 2] * row[std::clamp(2 * x + k, 0, width - 1)];
            }
            out[x] = static_cast<std::uint8_t>(sum / 16);
        }
    }
    return to;
}

Map halvedAlongY(const Map& from, int width, int height) {
    const int half = (height + 1) / 2;
    Map to(static_cast<std::size_t>(width) * static_cast<std::size_t>(half));
    for (int y = 0; y < half; ++y) {
        const std::uint8_t* rows[5];
        for (int k = -2; k <= 2; ++k)
            rows[k + 2] = from.data() +
                          static_cast<std::ptrdiff_t>(std::clamp(2 * y + k, 0, height - 1)) * width;
        std::uint8_t* out = to.data() + static_cast<std::ptrdiff_t>(y) * width;
        for (int x = 0; x < width; ++x)
            out[x] = static_cast<std::uint8_t>(
                (rows[0][x] + 4 * rows[1][x] + 6 * rows[2][x] + 4 * rows[3][x] + rows[4][x] + 8) /
                16);
    }
    return to;
}

/// A run of pixels, each weighted with its neighbours, 1 2 1.
void soften(const std::uint8_t* before, const std::uint8_t* here, const std::uint8_t* behind,
            int count, std::uint8_t* out) {
    for (int i = 0; i < count; ++i)
        out[i] = static_cast<std::uint8_t>((before[i] + 2 * here[i] + behind[i] + 2) / 4);
}

Map softened(const Map& from, int width, int height) {
    Map rows(from.size()), both(from.size());
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* row = from.data() + static_cast<std::ptrdiff_t>(y) * width;
        std::uint8_t* out = rows.data() + static_cast<std::ptrdiff_t>(y) * width;
        out[0] = row[0];
        out[width - 1] = row[width - 1];
        soften(row, row + 1, row + 2, width - 2, out + 1);
    }
    for (int y = 0; y < height; ++y) {
        const auto at = [&](int line) {
            return rows.data() +
                   static_cast<std::ptrdiff_t>(std::clamp(line, 0, height - 1)) * width;
        };
        soften(at(y - 1), at(y), at(y + 1), width,
               both.data() + static_cast<std::ptrdiff_t>(y) * width);
    }
    return both;
}

}  // namespace

Planes planesOf(const Picture& picture) {
    Planes planes{picture.width, picture.height, {}};
    const std::size_t pixels = picture.rgba.size() / 4;
    for (std::size_t c = 0; c < 3; ++c) {
        planes.channel[c].resize(pixels);
        for (std::size_t i = 0; i < pixels; ++i)
            planes.channel[c][i] = picture.rgba[4 * i + c];
    }
    return planes;
}

Planes halved(const Planes& planes) {
    Planes half{(planes.width + 1) / 2, (planes.height + 1) / 2, {}};
    for (int c = 0; c < 3; ++c)
        half.channel[c] = halvedAlongY(halvedAlongX(planes.channel[c], planes.width, planes.height),
                                       half.width, planes.height);
    return half;
}

Planes softened(const Planes& planes) {
    Planes soft{planes.width, planes.height, {}};
    for (int c = 0; c < 3; ++c)
        soft.channel[c] = softened(planes.channel[c], planes.width, planes.height);
    return soft;
}

}  // namespace grader
