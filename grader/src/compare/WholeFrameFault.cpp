#include "compare/WholeFrameFault.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "compare/PixelError.h"

namespace grader {

namespace {

using Table = std::array<std::uint8_t, 256>;

/// What undoes a wrong power: v → v^exponent of values from 0 to 1.
Table powers(double exponent) {
    Table table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<std::uint8_t>(
            std::lround(255 * std::pow(static_cast<double>(i) / 255, exponent)));
    return table;
}

Picture throughTable(const Picture& frame, const Table& table) {
    Picture mended = frame;
    for (std::size_t i = 0; i < mended.rgba.size(); ++i)
        if (i % 4 != 3)
            mended.rgba[i] = table[mended.rgba[i]];
    return mended;
}

Picture withOrder(const Picture& frame, const std::array<std::size_t, 3>& order) {
    Picture mended = frame;
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            mended.rgba[i + c] = frame.rgba[i + order[c]];
    return mended;
}

Picture turned(const Picture& frame, bool rows, bool columns) {
    Picture mended = frame;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const std::uint8_t* from =
                frame.pixel(columns ? frame.width - 1 - x : x, rows ? frame.height - 1 - y : y);
            std::copy(from, from + 4, mended.pixel(x, y));
        }
    return mended;
}

struct Candidate {
    const char* id;
    const char* says;
    std::function<Picture(const Picture&)> undo;
};

const std::vector<Candidate>& candidates() {
    static const std::vector<Candidate> all = {
        {"rows-flipped", "its rows are upside down",
         [](const Picture& p) { return turned(p, true, false); }},
        {"columns-flipped", "left and right are exchanged, as in a mirror",
         [](const Picture& p) { return turned(p, false, true); }},
        {"turned", "it is turned by 180 degrees",
         [](const Picture& p) { return turned(p, true, true); }},
        {"red-and-blue", "red and blue are exchanged",
         [](const Picture& p) {
             return withOrder(p, {2, 1, 0});
         }},
        {"red-and-green", "red and green are exchanged",
         [](const Picture& p) {
             return withOrder(p, {1, 0, 2});
         }},
        {"green-and-blue", "green and blue are exchanged",
         [](const Picture& p) {
             return withOrder(p, {0, 2, 1});
         }},
        {"channels-rotated", "red, green and blue are in another order",
         [](const Picture& p) {
             return withOrder(p, {1, 2, 0});
         }},
        {"channels-rotated", "red, green and blue are in another order",
         [](const Picture& p) {
             return withOrder(p, {2, 0, 1});
         }},
        {"gamma-missing", "gamma is missing: it is too dark in between",
         [](const Picture& p) { return throughTable(p, powers(1 / 2.2)); }},
        {"gamma-doubled", "gamma is applied once too often: it is too bright in between",
         [](const Picture& p) { return throughTable(p, powers(2.2)); }},
    };
    return all;
}

/// Every eighth pixel of every eighth row, placed evenly about the middle.
Picture thinned(const Picture& picture) {
    constexpr int kStep = 8;
    Picture thin{picture.width / kStep, picture.height / kStep, {}, {}};
    for (int y = 0; y < thin.height; ++y)
        for (int x = 0; x < thin.width; ++x) {
            const std::uint8_t* pixel = picture.pixel(kStep * x + kStep / 2, kStep * y + kStep / 2);
            thin.rgba.insert(thin.rgba.end(), pixel, pixel + 4);
        }
    return thin;
}

/// Share of the pixels that differ much.
double differing(const Picture& a, const Picture& b) {
    const Map difference = plainDifference(planesOf(a), planesOf(b));
    const auto much = std::count_if(difference.begin(), difference.end(),
                                    [](std::uint8_t each) { return each > kSaturated / 4; });
    return difference.empty() ? 0.0
                              : static_cast<double>(much) / static_cast<double>(difference.size());
}

}  // namespace

std::optional<WholeFrameFault> findWholeFrameFault(const Picture& frame, const Picture& reference) {
    constexpr double kRough = 0.1;  // the thinned picture is a pixel off where it is turned
    const Picture thinFrame = thinned(frame), thinReference = thinned(reference);
    const Planes wanted = planesOf(reference);
    for (const Candidate& candidate : candidates()) {
        if (differing(candidate.undo(thinFrame), thinReference) > kRough)
            continue;
        Picture mended = candidate.undo(frame);
        const Map difference = tolerantDifference(planesOf(mended), wanted);
        const double outliers =
            sumErrors(difference, frame.width).outliers / static_cast<double>(difference.size());
        if (outliers <= kStrayPixels)
            return WholeFrameFault{candidate.id, candidate.says, std::move(mended)};
    }
    return std::nullopt;
}

}  // namespace grader
