#include "compare/Sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

/// "the top left"
std::string placeName(const FrameScore& score, const Picture& picture) {
    static const char* rows[] = {"top", "middle", "bottom"};
    static const char* columns[] = {"left", "centre", "right"};
    const int row = std::min(2, 3 * score.centreY / std::max(1, picture.height));
    const int column = std::min(2, 3 * score.centreX / std::max(1, picture.width));
    if (row == 1 && column == 1)
        return "the middle";
    return fmt::format("the {} {}", rows[row], columns[column]);
}

/// "12 345" → digits in groups of three.
std::string grouped(double number) {
    std::string digits = fmt::format("{:.0f}", number);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), " ");
    return digits;
}

int percent(double share) {
    return static_cast<int>(std::floor(100 * share + 1e-9));  // what is not all is not 100 %
}

}  // namespace

std::string sentenceOn(const FrameScore& score, const Picture& frame, const Picture& reference) {
    if (!score.sizeMatches)
        return fmt::format("expected {} x {} pixels, got {} x {}", reference.width,
                           reference.height, frame.width, frame.height);
    if (score.fault)
        return fmt::format("the picture is right but for one thing: {}", score.fault->says);
    if (score.score >= 1)
        return fmt::format("{:.2f} % of the pixels differ", 100 * score.outliers);
    std::string differ = fmt::format("{:.1f} % of the pixels differ, mostly in {}",
                                     100 * score.outliers, placeName(score, reference));
    if (!frame.broken.empty())
        differ += fmt::format("; {} are no number (NaN or infinite)",
                              grouped(static_cast<double>(frame.broken.size())));
    if (score.displacement)
        return fmt::format("{}; what is shown is {}", differ, score.displacement->text());
    if (score.score <= 0)
        return differ + "; the picture is no nearer to the right one than the starter's";
    return fmt::format("{}; the picture is {} % of the way from the starter's to the right one",
                       differ, percent(score.score));
}

std::string sentenceOn(const FeatureScore& score, const std::string& title, double pixels) {
    if (score.score >= 1)
        return "";
    const std::string where =
        fmt::format("in the {} pixels that show {} ({:.1f} % of the picture)",
                    grouped(score.pixels), title, 100 * score.pixels / pixels);
    if (score.displacement)
        return fmt::format("{} it is drawn {}", where, score.displacement->text());
    if (score.score <= 0)
        return where + " yours is no nearer to the right picture than one without";
    return fmt::format("{} yours is {} % of the way to the right picture", where,
                       percent(score.score));
}

}  // namespace grader
