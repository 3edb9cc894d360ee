#include "compare/PixelError.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace grader {

namespace {

const std::array<float, 256>& errors() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (int i = 0; i < 256; ++i)
            values[static_cast<std::size_t>(i)] = std::clamp(
                static_cast<float>(i - kDeadZone) / (kSaturated - kDeadZone), 0.0f, 1.0f);
        return values;
    }();
    return table;
}

/// Lowers `least[i]` to the difference of a[i] and b[i + shift], and `back[i + shift]` likewise,
/// for `count` pixels from index `first` on.
void lower(const Planes& a, const Planes& b, std::size_t first, std::ptrdiff_t shift, int count,
           Map& least, Map& back) {
    const auto at = static_cast<std::ptrdiff_t>(first);
    const std::uint8_t* ar = a.channel[0].data() + at;
    const std::uint8_t* ag = a.channel[1].data() + at;
    const std::uint8_t* ab = a.channel[2].data() + at;
    const std::uint8_t* br = b.channel[0].data() + at + shift;
    const std::uint8_t* bg = b.channel[1].data() + at + shift;
    const std::uint8_t* bb = b.channel[2].data() + at + shift;
    std::uint8_t* to = least.data() + at;
    std::uint8_t* from = back.data() + at + shift;
    for (int x = 0; x < count; ++x) {
        const std::uint8_t difference =
            std::max(std::max(away(ar[x], br[x]), away(ag[x], bg[x])), away(ab[x], bb[x]));
        to[x] = std::min(to[x], difference);
        from[x] = std::min(from[x], difference);
    }
}

}  // namespace

Map tolerantDifference(const Planes& a, const Planes& b) {
    Map least(a.size(), 255), back(a.size(), 255);
    for (int y = 0; y < a.height; ++y)  // outermost: three rows stay in the cache
        for (int dy = -1; dy <= 1; ++dy) {
            if (y + dy < 0 || y + dy >= a.height)
                continue;
            for (int dx = -1; dx <= 1; ++dx)
                lower(a, b, static_cast<std::size_t>(y * a.width + std::max(0, -dx)),
                      dy * a.width + dx, a.width - std::abs(dx), least, back);
        }
    for (std::size_t i = 0; i < least.size(); ++i)
        least[i] = std::max(least[i], back[i]);
    return least;
}

Map plainDifference(const Planes& a, const Planes& b) {
    Map difference(a.size());
    for (std::size_t i = 0; i < difference.size(); ++i)
        difference[i] = std::max({away(a.channel[0][i], b.channel[0][i]),
                                  away(a.channel[1][i], b.channel[1][i]),
                                  away(a.channel[2][i], b.channel[2][i])});
    return difference;
}

float errorOf(std::uint8_t difference) {
    return errors()[difference];
}

ErrorSum sumErrors(const Map& differences, int width) {
    ErrorSum sum;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        if (differences[i] <= kDeadZone)
            continue;
        const double error = errorOf(differences[i]);
        const auto columns = static_cast<std::size_t>(width);
        sum.error += error;
        sum.outliers += 1;
        sum.x += error * static_cast<double>(i % columns);
        sum.y += error * static_cast<double>(i / columns);
    }
    return sum;
}

double sumErrors(const Map& differences, const Map& mask) {
    double sum = 0;
    for (std::size_t i = 0; i < differences.size(); ++i)
        if (mask[i])
            sum += errorOf(differences[i]);
    return sum;
}

}  // namespace grader
