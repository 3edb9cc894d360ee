#include "compare/WholeFrameFault.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "compare/PixelError.h"

namespace grader {

namespace {

using Table = std::array<std::uint8_t, 256>;

/// v → v^exponent of values from 0 to 1.
Table powers(double exponent) {
    Table table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<std::uint8_t>(
            std::lround(255 * std::pow(static_cast<double>(i) / 255, exponent)));
    return table;
}

Picture throughTable(const Picture& picture, const Table& table) {
    Picture spoilt = picture;
    for (std::size_t i = 0; i < spoilt.rgba.size(); ++i)
        if (i % 4 != 3)
            spoilt.rgba[i] = table[spoilt.rgba[i]];
    return spoilt;
}

Picture withOrder(const Picture& picture, const std::array<std::size_t, 3>& order) {
    Picture spoilt = picture;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            spoilt.rgba[i + c] = picture.rgba[i + order[c]];
    return spoilt;
}

Picture turned(const Picture& picture, bool rows, bool columns) {
    Picture spoilt = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint8_t* from = picture.pixel(columns ? picture.width - 1 - x : x,
                                                     rows ? picture.height - 1 - y : y);
            std::copy(from, from + 4, spoilt.pixel(x, y));
        }
    return spoilt;
}

struct Candidate {
    const char* id;
    const char* says;
    std::function<Picture(const Picture&)> spoil;
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
         [](const Picture& p) { return throughTable(p, powers(2.2)); }},
        {"gamma-doubled", "gamma is applied once too often: it is too bright in between",
         [](const Picture& p) { return throughTable(p, powers(1 / 2.2)); }},
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

double shareAbove(const Map& differences, int most) {
    const auto above = std::count_if(differences.begin(), differences.end(),
                                     [most](std::uint8_t each) { return each > most; });
    return static_cast<double>(above) / static_cast<double>(differences.size());
}

}  // namespace

std::optional<WholeFrameFault> findWholeFrameFault(const Picture& frame, const Picture& reference,
                                                   double outliers) {
    constexpr double kRough = 0.1;  // the thinned picture is a pixel off where it is turned
    const Picture thinReference = thinned(reference);
    if (thinReference.empty())
        return std::nullopt;
    const Planes planes = planesOf(frame), thinPlanes = planesOf(thinned(frame));
    const Planes flat = planesOf(flatPicture(frame, mostFrequentColour(frame)));
    if (shareAbove(plainDifference(planes, flat), kDeadZone) <= kStrayPixels)
        return std::nullopt;  // shows nothing that could be wrong
    const double allowed = std::min(kStrayPixels, 0.1 * outliers);
    for (const Candidate& candidate : candidates())
        if (shareAbove(plainDifference(planesOf(candidate.spoil(thinReference)), thinPlanes),
                       kDeadZone) <= kRough &&
            shareAbove(tolerantDifference(planes, planesOf(candidate.spoil(reference))),
                       kDeadZone) <= allowed)
            return WholeFrameFault{candidate.id, candidate.says};
    return std::nullopt;
}

}  // namespace grader
