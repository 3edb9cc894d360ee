#include "compare/Boundary.h"

#include <algorithm>

namespace grader {

namespace {

// All of it is done at half size, where the noise that drivers differ by is averaged out.
constexpr int kFaint = 12;     // of 255: a step up to this is no boundary
constexpr int kClear = 48;     // of 255: a step from this on is one
constexpr int kReach = 1;      // pixels of half size, two of the picture
constexpr int kNoise = 6;      // of 255: steps that say nothing about sharpness
constexpr int kContrast = 64;  // of 255: within a block, something to be sharp about
constexpr int kBlock = 16;     // pixels of half size: as far as a blur may reach

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

/// Largest difference of one channel within a block.
int contrastOf(const Planes& planes, int bx, int by) {
    int contrast = 0;
    for (const Map& channel : planes.channel) {
        int least = 255, most = 0;
        for (int y = by; y < by + kBlock; ++y)
            for (int x = bx; x < bx + kBlock; ++x) {
                const int value = channel[static_cast<std::size_t>(y * planes.width + x)];
                least = std::min(least, value);
                most = std::max(most, value);
            }
        contrast = std::max(contrast, most - least);
    }
    return contrast;
}

/// Over blocks with much contrast: the mean step, weighted by steps, as a share of the contrast. A
/// boundary spread over w pixels gives 1 / w, however long it is.
double sharpnessOf(const Planes& planes, const Map& steps) {
    double squares = 0, products = 0;
    bool any = false;
    for (int by = 0; by + kBlock <= planes.height; by += kBlock)
        for (int bx = 0; bx + kBlock <= planes.width; bx += kBlock) {
            const int contrast = contrastOf(planes, bx, by);
            if (contrast < kContrast)
                continue;
            any = true;
            for (int y = by; y < by + kBlock; ++y)
                for (int x = bx; x < bx + kBlock; ++x) {
                    const double step =
                        std::max(0, steps[static_cast<std::size_t>(y * planes.width + x)] - kNoise);
                    squares += step * step;
                    products += step * contrast;
                }
        }
    return products > 0 ? squares / products : any ? 0.0 : 1.0;
}

/// Share of the edges that lie near the other's.
double shareNear(const Boundaries& edges, const Boundaries& others) {
    if (edges.count == 0)
        return others.count == 0 ? 1.0 : 0.0;
    double met = 0;
    for (std::size_t i = 0; i < edges.edges.size(); ++i)
        met += std::min(edges.edges[i], others.near[i]);
    return met / edges.count;
}

}  // namespace

Boundaries boundariesOf(const Planes& planes) {
    const Planes half = halved(planes);
    Boundaries boundaries;
    const Map steps = stepsOf(half);
    boundaries.edges.resize(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        boundaries.edges[i] = static_cast<std::uint8_t>(
            std::clamp((steps[i] - kFaint) * 255 / (kClear - kFaint), 0, 255));
        boundaries.count += boundaries.edges[i];
    }
    boundaries.near = dilated(boundaries.edges, half.width, half.height);
    boundaries.sharpness = sharpnessOf(half, steps);
    return boundaries;
}

double boundaryMatch(const Boundaries& frame, const Boundaries& reference) {
    const double precision = shareNear(frame, reference), recall = shareNear(reference, frame);
    return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0.0;
}

}  // namespace grader
