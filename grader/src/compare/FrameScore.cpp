#include "compare/FrameScore.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

namespace grader {

namespace {

constexpr int kDeadZone = 4;    // of 255: what correct drivers differ by
constexpr int kSaturated = 64;  // of 255: as wrong as can be
constexpr double kMostWhenLost = 0.99;

int channelDifference(const std::uint8_t* a, const std::uint8_t* b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// From `from` at (x, y) to the best match near (x, y) in `to`.
int nearestDifference(const Picture& from, const Picture& to, int x, int y) {
    const std::uint8_t* pixel = from.pixel(x, y);
    int least = channelDifference(pixel, to.pixel(x, y));
    for (int ny = std::max(0, y - 1); least > kDeadZone && ny <= std::min(to.height - 1, y + 1);
         ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(to.width - 1, x + 1); ++nx)
            least = std::min(least, channelDifference(pixel, to.pixel(nx, ny)));
    return least;
}

double errorOf(const Picture& a, const Picture& b, int x, int y) {
    const int difference = std::max(nearestDifference(a, b, x, y), nearestDifference(b, a, x, y));
    return std::clamp(double(difference - kDeadZone) / (kSaturated - kDeadZone), 0.0, 1.0);
}

struct ErrorSum {
    double error = 0, outliers = 0, x = 0, y = 0;
};

ErrorSum sumErrors(const Picture& frame, const Picture& reference) {
    ErrorSum sum;
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            const double error = errorOf(frame, reference, x, y);
            if (error <= 0)
                continue;
            sum.error += error;
            sum.outliers += 1;
            sum.x += error * x;
            sum.y += error * y;
        }
    return sum;
}

Picture flat(const Picture& like, const std::array<std::uint8_t, 3>& colour) {
    Picture picture = like;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        std::copy(colour.begin(), colour.end(), picture.rgba.begin() + static_cast<long>(i));
    return picture;
}

std::array<std::uint8_t, 3> meanColour(const Picture& picture) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += picture.rgba[i + c];
    const double pixels = double(picture.rgba.size()) / 4;
    std::array<std::uint8_t, 3> mean{};
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<std::uint8_t>(std::lround(sum[c] / pixels));
    return mean;
}

/// In nearly every scene the clear colour.
std::array<std::uint8_t, 3> mostFrequentColour(const Picture& picture) {
    std::map<std::array<std::uint8_t, 3>, int> count;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        ++count[{picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]}];
    return std::max_element(count.begin(), count.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

/// Mean error of the best picture that takes no work.
double baselineError(const Picture& reference, const Picture& starter) {
    const double pixels = double(reference.width) * reference.height;
    double least = pixels;
    for (const auto& colour : {std::array<std::uint8_t, 3>{0, 0, 0}, meanColour(reference),
                               mostFrequentColour(reference)})
        least = std::min(least, sumErrors(flat(reference, colour), reference).error);
    if (starter.sameSizeAs(reference))
        least = std::min(least, sumErrors(starter, reference).error);
    return least / pixels;
}

std::string placeName(const FrameScore& score, const Picture& picture) {
    static const char* rows[] = {"top", "middle", "bottom"};
    static const char* columns[] = {"left", "centre", "right"};
    const int row = std::min(2, 3 * score.centreY / std::max(1, picture.height));
    const int column = std::min(2, 3 * score.centreX / std::max(1, picture.width));
    if (row == 1 && column == 1)
        return "the middle";
    return fmt::format("the {} {}", rows[row], columns[column]);
}

}  // namespace

FrameScore scoreFrame(const Picture& frame, const Picture& reference, const Picture& starter,
                      double tolerance) {
    FrameScore result;
    result.sizeMatches = frame.sameSizeAs(reference);
    if (!result.sizeMatches || reference.empty()) {
        result.meanError = result.outliers = 1;
        return result;
    }
    const double pixels = double(reference.width) * reference.height;
    const ErrorSum sum = sumErrors(frame, reference);
    result.meanError = sum.error / pixels;
    result.outliers = sum.outliers / pixels;
    if (sum.error > 0) {
        result.centreX = static_cast<int>(sum.x / sum.error);
        result.centreY = static_cast<int>(sum.y / sum.error);
    }
    if (result.outliers <= tolerance) {
        result.score = result.skill = 1;
        return result;
    }
    result.baseline = baselineError(reference, starter);
    if (result.baseline > 0)
        result.skill = std::clamp(1 - result.meanError / result.baseline, 0.0, 1.0);
    result.score = std::min(result.skill, kMostWhenLost);
    return result;
}

std::string explainScore(const FrameScore& score, const Picture& frame, const Picture& reference) {
    if (!score.sizeMatches)
        return fmt::format("expected {} x {} pixels, got {} x {}", reference.width,
                           reference.height, frame.width, frame.height);
    if (score.score >= 1)
        return fmt::format("{:.2f} % of the pixels differ", 100 * score.outliers);
    const std::string differ = fmt::format("{:.1f} % of the pixels differ, mostly in {}",
                                           100 * score.outliers, placeName(score, reference));
    if (score.score <= 0)
        return differ + "; the picture is no nearer to the reference than the starter's";
    return fmt::format("{}; the picture is {:.0f} % of the way from the starter's to the reference",
                       differ, 100 * score.score);
}

Picture differenceOf(const Picture& frame, const Picture& reference) {
    Picture difference = reference;
    if (!frame.sameSizeAs(reference))
        return flat(reference, {255, 255, 255});
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x) {
            const auto value =
                static_cast<std::uint8_t>(std::lround(255 * errorOf(frame, reference, x, y)));
            auto* pixel = const_cast<std::uint8_t*>(difference.pixel(x, y));
            pixel[0] = pixel[1] = pixel[2] = value;
            pixel[3] = 255;
        }
    return difference;
}

}  // namespace grader
