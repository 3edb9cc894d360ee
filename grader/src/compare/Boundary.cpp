#include "compare/Boundary.h"

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

// All of it is done at half size, where the noise that drivers differ by is averaged out.
constexpr int kFaint = 12;  // of 255: a step up to this is no boundary
constexpr int kClear = 48;  // of 255: a step from this on is one
constexpr int kReach = 1;   // pixels of half size, two of the picture
// Of 441, the way from black to white:
constexpr float kNoise = 9;  // gradients up to it say nothing about sharpness
constexpr float kSomeContrast = 56, kMuchContrast = 80;  // something to be sharp about
constexpr int kBlock = 8;  // pixels of quarter size: as far as a blur may reach

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

/// Length of the colour's gradient; noise hardly lengthens a long one.
float gradientAt(const Planes& planes, std::size_t i) {
    int squares = 0;
    for (const Map& channel : planes.channel) {
        const int along = channel[i + 1] - channel[i];
        const int down = channel[i + static_cast<std::size_t>(planes.width)] - channel[i];
        squares += along * along + down * down;
    }
    return std::sqrt(static_cast<float>(squares));
}

/// How far apart the colours of a block are.
float contrastOf(const Planes& planes, int bx, int by) {
    int squares = 0;
    for (const Map& channel : planes.channel) {
        int least = 255, most = 0;
        for (int y = by; y < by + kBlock; ++y)
            for (int x = bx; x < bx + kBlock; ++x) {
                const int value = channel[static_cast<std::size_t>(y * planes.width + x)];
                least = std::min(least, value);
                most = std::max(most, value);
            }
        squares += (most - least) * (most - least);
    }
    return std::sqrt(static_cast<float>(squares));
}

/// Over blocks with contrast: the mean gradient, weighted by gradients, as a share of the contrast.
/// A boundary spread over w pixels gives 1 / w, however long it is. The contrast is taken at
/// quarter size, where no noise is left that would widen it.
double sharpnessOf(const Planes& half) {
    const Planes quarter = softened(halved(half));
    double squares = 0, products = 0;
    bool any = false;
    for (int by = 0; 2 * (by + kBlock) < half.height; by += kBlock)
        for (int bx = 0; 2 * (bx + kBlock) < half.width; bx += kBlock) {
            const float contrast = contrastOf(quarter, bx, by);
            const float weight = std::clamp(
                (contrast - kSomeContrast) / (kMuchContrast - kSomeContrast), 0.0f, 1.0f);
            if (weight == 0)
                continue;
            any = true;
            for (int y = 2 * by; y < 2 * (by + kBlock); ++y)
                for (int x = 2 * bx; x < 2 * (bx + kBlock); ++x) {
                    const float gradient =
                        gradientAt(half, static_cast<std::size_t>(y * half.width + x));
                    const float step = std::max(0.0f, gradient - kNoise);
                    squares += weight * step * step;
                    products += weight * step * contrast;
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
    boundaries.sharpness = sharpnessOf(half);
    return boundaries;
}

double boundaryMatch(const Boundaries& frame, const Boundaries& reference) {
    const double precision = shareNear(frame, reference), recall = shareNear(reference, frame);
    return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0.0;
}

}  // namespace grader
