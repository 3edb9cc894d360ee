#include "compare/Displacement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/PixelError.h"

namespace grader {

namespace {

constexpr double kMatches = 0.35;  // mean error up to which an object counts as found again
constexpr double kSurely = 0.2;    // and up to which it counts for all that it is
constexpr double kShorter = 1e-3;  // error that a pixel of way is worth: of two matches the nearer
constexpr double kFewestPixels = 40;       // of an object, at full size
constexpr std::size_t kMostPixels = 6000;  // looked at for one shift
constexpr std::size_t kCandidates = 4;     // kept from one scale to the next
constexpr int kRefine = 4;                 // pixels around a candidate, in the finer scale

struct Shift {
    int x, y;
    double error;
};

struct Place {
    int x, y;
};

/// Pixels of the object at a scale, thinned out evenly.
std::vector<Place> placesOf(const Map& object, int width, int height, int scale) {
    std::vector<Place> places;
    const int w = (width + scale - 1) / scale, h = (height + scale - 1) / scale;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            if (object[static_cast<std::size_t>(y * scale * width + x * scale)])
                places.push_back({x, y});
    const std::size_t step = places.size() / kMostPixels + 1;
    std::vector<Place> thinned;
    for (std::size_t i = 0; i < places.size(); i += step)
        thinned.push_back(places[i]);
    return thinned;
}

/// Mean error of the object's pixels when the frame is looked at (x, y) further on.
double errorAt(const Planes& frame, const Planes& reference, const std::vector<Place>& places,
               int x, int y) {
    double sum = 0;
    for (const Place& place : places) {
        const int fx = place.x + x, fy = place.y + y;
        if (fx < 0 || fy < 0 || fx >= frame.width || fy >= frame.height) {
            sum += 1;
            continue;
        }
        const auto there = static_cast<std::size_t>(fy * frame.width + fx);
        const auto here = static_cast<std::size_t>(place.y * frame.width + place.x);
        int most = 0;
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(frame.channel[c][there] - reference.channel[c][here]));
        sum += errorOf(static_cast<std::uint8_t>(most));
    }
    return sum / static_cast<double>(places.size());
}

/// The best few, no two of them neighbours.
std::vector<Shift> best(std::vector<Shift> shifts, std::size_t count) {
    const auto cost = [](const Shift& each) {
        return each.error + kShorter * std::hypot(each.x, each.y);
    };
    std::sort(shifts.begin(), shifts.end(),
              [&](const Shift& a, const Shift& b) { return cost(a) < cost(b); });
    std::vector<Shift> kept;
    for (const Shift& each : shifts) {
        const bool beside = std::any_of(kept.begin(), kept.end(), [&](const Shift& other) {
            return std::abs(other.x - each.x) <= 1 && std::abs(other.y - each.y) <= 1;
        });
        if (!beside)
            kept.push_back(each);
        if (kept.size() == count)
            break;
    }
    return kept;
}

}  // namespace

double Displacement::length() const {
    return std::hypot(x, y);
}

double Displacement::credit(int pictureWidth) const {
    const double found = std::clamp((kMatches - error) / (kMatches - kSurely), 0.0, 1.0);
    return found * (1 - error) * std::exp(-length() / (pictureWidth / 8.0));
}

std::string Displacement::text() const {
    std::string text;
    if (x != 0)
        text = fmt::format("{} px too far {}", std::abs(x), x > 0 ? "right" : "left");
    if (y != 0)
        text += fmt::format("{}{} px too {}", text.empty() ? "" : " and ", std::abs(y),
                            y > 0 ? "low" : "high");
    return text;
}

Scales scalesOf(Planes planes) {
    Scales scales;
    scales.planes[0] = std::move(planes);
    scales.planes[1] = halved(halved(scales.planes[0]));
    scales.planes[2] = halved(halved(scales.planes[1]));
    scales.soft = softened(scales.planes[0]);
    return scales;
}

std::optional<Displacement> findDisplacement(const Scales& frame, const Scales& reference,
                                             const Map& object) {
    const int width = reference.planes[0].width, height = reference.planes[0].height;
    if (placesOf(object, width, height, 1).size() < kFewestPixels)
        return std::nullopt;
    std::vector<Shift> shifts;
    for (int level = 2; level >= 0; --level) {
        const Planes& f = level ? frame.planes[level] : frame.soft;
        const Planes& r = level ? reference.planes[level] : reference.soft;
        const auto places = placesOf(object, width, height, kScales[level]);
        if (places.empty())
            continue;  // too small to be seen at this scale
        std::vector<Shift> tried;
        const auto look = [&](int x, int y) {
            tried.push_back({x, y, errorAt(f, r, places, x, y)});
        };
        if (shifts.empty()) {
            for (int y = -f.height / 2; y <= f.height / 2; ++y)
                for (int x = -f.width / 2; x <= f.width / 2; ++x)
                    look(x, y);
        } else {
            for (const Shift& coarse : shifts)
                for (int y = -kRefine; y <= kRefine; ++y)
                    for (int x = -kRefine; x <= kRefine; ++x)
                        look(4 * coarse.x + x, 4 * coarse.y + y);
        }
        shifts = best(std::move(tried), level == 0 ? 1 : kCandidates);
    }
    const Shift& found = shifts.front();
    if (found.error > kMatches || std::hypot(found.x, found.y) < 1.5)
        return std::nullopt;
    return Displacement{found.x, found.y, found.error};
}

}  // namespace grader
