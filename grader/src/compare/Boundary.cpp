#include "compare/Boundary.h"

#include <algorithm>

namespace grader {

namespace {

constexpr int kStep = 24;      // of 255: between neighbours, a boundary
constexpr int kReach = 2;      // pixels
constexpr int kContrast = 64;  // of 255: within a block, something to be sharp about
constexpr int kBlock = 32;     // pixels: as far as a blur may reach

std::uint8_t away(std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a > b ? a - b : b - a);
}

/// Largest step of any channel to the neighbour `shift` pixels on, for `count` pixels.
void raise(const Planes& planes, std::size_t first, std::size_t shift, int count, Map& steps) {
    for (const Map& channel : planes.channel) {
        const std::uint8_t* here = channel.data() + first;
        const std::uint8_t* there = here + shift;
        std::uint8_t* to = steps.data() + first;
        for (int x = 0; x < count; ++x)
            to[x] = std::max(to[x], away(here[x], there[x]));
    }
}

Map stepsOf(const Planes& planes) {
    Map steps(planes.size(), 0);
    const auto width = static_cast<std::size_t>(planes.width);
    for (int y = 0; y < planes.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * width;
        raise(planes, row, 1, planes.width - 1, steps);
        if (y + 1 < planes.height)
            raise(planes, row, width, planes.width, steps);
    }
    return steps;
}

Map dilated(const Map& map, int width, int height) {
    Map along(map.size(), 0), both(map.size(), 0);
    for (int y = 0; y < height; ++y)
        for (int d = -kReach; d <= kReach; ++d) {
            const auto row = static_cast<std::ptrdiff_t>(y) * width;
            const std::uint8_t* from = map.data() + row + d;
            std::uint8_t* to = along.data() + row;
            for (int x = std::max(0, -d); x < width - std::max(0, d); ++x)
                to[x] = std::max(to[x], from[x]);
        }
    for (int y = 0; y < height; ++y)
        for (int d = -kReach; d <= kReach; ++d) {
            if (y + d < 0 || y + d >= height)
                continue;
            const std::uint8_t* from = along.data() + static_cast<std::ptrdiff_t>(y + d) * width;
            std::uint8_t* to = both.data() + static_cast<std::ptrdiff_t>(y) * width;
            for (int x = 0; x < width; ++x)
                to[x] = std::max(to[x], from[x]);
        }
    return both;
}

/// Mean, over blocks with much contrast, of the largest step between neighbours as a share of the
/// contrast: near 1 where things are drawn, near 0 where they are blurred.
double sharpnessOf(const Planes& planes, const Map& steps) {
    double sharp = 0, contrasts = 0;
    for (int by = 0; by + kBlock <= planes.height; by += kBlock)
        for (int bx = 0; bx + kBlock <= planes.width; bx += kBlock) {
            int step = 0, contrast = 0;
            for (int c = 0; c < 3; ++c) {
                int least = 255, most = 0;
                for (int y = by; y < by + kBlock; ++y)
                    for (int x = bx; x < bx + kBlock; ++x) {
                        const int value =
                            planes.channel[c][static_cast<std::size_t>(y * planes.width + x)];
                        least = std::min(least, value);
                        most = std::max(most, value);
                    }
                contrast = std::max(contrast, most - least);
            }
            if (contrast < kContrast)
                continue;
            for (int y = by; y < by + kBlock; ++y)
                for (int x = bx; x < bx + kBlock; ++x)
                    step =
                        std::max<int>(step, steps[static_cast<std::size_t>(y * planes.width + x)]);
            sharp += std::min(step, contrast);
            contrasts += contrast;
        }
    return contrasts > 0 ? sharp / contrasts : 1.0;
}

/// Share of the edges that lie near the other's.
double shareNear(const Boundaries& edges, const Boundaries& others) {
    if (edges.count == 0)
        return others.count == 0 ? 1.0 : 0.0;
    double met = 0;
    for (std::size_t i = 0; i < edges.edges.size(); ++i)
        met += edges.edges[i] & others.near[i];
    return met / edges.count;
}

}  // namespace

Boundaries boundariesOf(const Planes& planes) {
    Boundaries boundaries;
    const Map steps = stepsOf(planes);
    boundaries.edges.resize(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        boundaries.edges[i] = steps[i] > kStep ? 1 : 0;
        boundaries.count += boundaries.edges[i];
    }
    boundaries.near = dilated(boundaries.edges, planes.width, planes.height);
    boundaries.sharpness = sharpnessOf(planes, steps);
    return boundaries;
}

double boundaryMatch(const Boundaries& frame, const Boundaries& reference) {
    const double precision = shareNear(frame, reference), recall = shareNear(reference, frame);
    return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0.0;
}

}  // namespace grader
