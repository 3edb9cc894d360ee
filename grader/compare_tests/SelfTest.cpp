// The scoring rule tried on pictures whose worth is known: a table of expected ranges, and what
// must hold between them. Prints the table of docs/scoring.md.

#include <fmt/format.h>

#include <iostream>
#include <limits>
#include <map>

#include "compare/FrameScore.h"
#include "compare_tests/Pictures.h"

namespace {

using grader::FrameRule;
using grader::FrameScore;
using grader::Picture;

/// What a picture may earn: of the whole frame and of the feature "the first thing", once a
/// whole-frame fault is charged.
struct Expected {
    const char* name;
    double wholeLow, wholeHigh, featureLow, featureHigh;
};

constexpr Expected kTable[] = {
    {"identical", 1, 1, 1, 1},
    {"noise of 3/255", 1, 1, 1, 1},
    {"shifted by one pixel", 1, 1, 1, 1},
    {"another triangle diagonal", 1, 1, 1, 1},
    {"displaced by 4 px", 0.2, 0.99, 0.7, 0.99},
    {"displaced by 12 px", 0.2, 0.95, 0.6, 0.95},
    {"displaced by 56 px", 0.1, 0.95, 0.4, 0.65},
    {"displaced by 140 px", 0.1, 0.95, 0.1, 0.3},
    {"missing", 0.1, 0.97, 0, 0},
    {"wrong colour", 0.1, 0.98, 0, 0.6},
    {"blurred by 2", 0.05, 0.99, 0, 0.99},
    {"blurred by 8", 0, 0.6, 0, 0.4},
    {"blurred by 32", 0, 0.5, 0, 0.2},
    {"displaced by 56 px, blurred by 8", 0, 0.5, 0, 0.4},
    {"missing, blurred by 8", 0, 0.5, 0, 0},
    {"wrong colour, blurred by 8", 0, 0.5, 0, 0.4},
    {"no gamma", 0.5, 0.5, 0.5, 0.5},
    {"double gamma", 0.5, 0.5, 0.5, 0.5},
    {"rows flipped", 0.5, 0.5, 0.5, 0.5},
    {"channels swapped", 0.5, 0.5, 0.5, 0.5},
    {"black", 0, 0, 0, 0},
    {"mean colour", 0, 0, 0, 0},
    {"clear colour", 0, 0, 0, 0},
    {"the starter's", 0, 0, 0, 0},
    {"wrong size", 0, 0, 0, 0},
    {"not a number everywhere", 0, 0, 0, 0},
    {"noise", 0, 0.05, 0, 0.1},
};

/// What noise of 3/255 may move a score that is not full by.
constexpr double kMostMoved = 0.005;

Picture broken(Picture picture) {
    for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i)
        picture.broken.push_back(i);
    return picture;
}

std::map<std::string, Picture> picturesOf(const trial::Scene& scene, const Picture& reference) {
    using namespace trial;
    std::map<std::string, Picture> all;
    all["identical"] = reference;
    all["noise of 3/255"] = noisy(reference, 3, 1);
    all["shifted by one pixel"] = shifted(reference, 1);
    all["another triangle diagonal"] = otherDiagonal(reference);
    for (const int pixels : {4, 12, 56, 140})
        all[fmt::format("displaced by {} px", pixels)] = moved(scene, pixels);
    all["missing"] = without(scene);
    all["wrong colour"] = painted(scene);
    for (const int radius : {2, 8, 32})
        all[fmt::format("blurred by {}", radius)] = blurred(reference, radius);
    all["displaced by 56 px, blurred by 8"] = blurred(moved(scene, 56), 8);
    all["missing, blurred by 8"] = blurred(without(scene), 8);
    all["wrong colour, blurred by 8"] = blurred(painted(scene), 8);
    all["no gamma"] = withPower(reference, 2.2);
    all["double gamma"] = withPower(reference, 1 / 2.2);
    all["rows flipped"] = flippedRows(reference);
    all["channels swapped"] = swappedChannels(reference);
    all["black"] = flatPicture(reference, {0, 0, 0});
    all["mean colour"] = flatPicture(reference, meanColour(reference));
    all["clear colour"] = flatPicture(reference, scene.clear);
    all["the starter's"] = starterOf(scene);
    all["wrong size"] = Picture{10, 10, std::vector<std::uint8_t>(400, 0), {}};
    all["not a number everywhere"] = broken(reference);
    all["noise"] = noisy(flatPicture(reference, {128, 128, 128}), 127, 2);
    return all;
}

struct Worth {
    double whole, feature;
};

class SelfTest {
public:
    explicit SelfTest(const trial::Scene& scene)
        : name_(scene.name),
          reference_(trial::draw(scene)),
          pictures_(picturesOf(scene, reference_)),
          rule_({reference_,
                 {trial::starterOf(scene)},
                 {{"first", "the first thing", trial::without(scene)}},
                 0.0005}) {}

    int run() {
        for (const Expected& row : kTable) {
            const Worth worth = worthOf(pictures_.at(row.name));
            worth_[row.name] = worth;
            std::cout << fmt::format("| {} | {} | {:.3f} | {:.3f} |\n", name_, row.name,
                                     worth.whole, worth.feature);
            demand(row.wholeLow <= worth.whole && worth.whole <= row.wholeHigh &&
                       row.featureLow <= worth.feature && worth.feature <= row.featureHigh,
                   fmt::format("{}: expected {} to {} and {} to {} for the feature", row.name,
                               row.wholeLow, row.wholeHigh, row.featureLow, row.featureHigh));
        }
        fartherIsLess();
        blurringNeverPays();
        noiseChangesNothing();
        return failures_;
    }

private:
    Worth worthOf(const Picture& picture) const {
        const FrameScore score = rule_.score(picture);
        const double kept = score.fault ? 1 - grader::kFaultCharge : 1;
        return {kept * score.score, kept * score.features.front().score};
    }

    void fartherIsLess() {
        double before = std::numeric_limits<double>::infinity();
        for (const char* name : {"displaced by 4 px", "displaced by 12 px", "displaced by 56 px",
                                 "displaced by 140 px", "missing"}) {
            demand(worth_.at(name).feature < before, std::string(name) + " earns too much");
            before = worth_.at(name).feature;
        }
    }

    void blurringNeverPays() {
        const std::pair<const char*, const char*> pairs[] = {
            {"blurred by 2", "identical"},
            {"blurred by 8", "blurred by 2"},
            {"blurred by 32", "blurred by 8"},
            {"displaced by 56 px, blurred by 8", "displaced by 56 px"},
            {"missing, blurred by 8", "missing"},
            {"wrong colour, blurred by 8", "wrong colour"}};
        for (const auto& [blurry, sharp] : pairs)
            demand(worth_.at(blurry).whole <= worth_.at(sharp).whole &&
                       worth_.at(blurry).feature <= worth_.at(sharp).feature,
                   fmt::format("{} earns more than {}", blurry, sharp));
    }

    void noiseChangesNothing() {
        for (const auto& [name, worth] : worth_) {
            if (std::string(name) == "noise of 3/255")
                continue;  // twice is too much
            const Worth noisy = worthOf(trial::noisy(pictures_.at(name), 3, 7));
            demand(std::abs(noisy.whole - worth.whole) <= kMostMoved &&
                       std::abs(noisy.feature - worth.feature) <= kMostMoved,
                   fmt::format("{}: noise of 3/255 moves the score from {:.4f}, {:.4f} to {:.4f}, "
                               "{:.4f}",
                               name, worth.whole, worth.feature, noisy.whole, noisy.feature));
        }
    }

    void demand(bool holds, const std::string& what) {
        if (holds)
            return;
        ++failures_;
        std::cout << "✗ " << name_ << ": " << what << "\n";
    }

    std::string name_;
    Picture reference_;
    std::map<std::string, Picture> pictures_;
    FrameRule rule_;
    std::map<std::string, Worth> worth_;
    int failures_ = 0;
};

}  // namespace

int main() {
    int failures = 0, scenes = 0;
    std::cout << "| scene | picture | whole frame | feature |\n|---|---|---|---|\n";
    for (const trial::Scene& scene : trial::scenes()) {
        failures += SelfTest(scene).run();
        ++scenes;
    }
    std::cout << fmt::format("{} scenes, {} failures\n", scenes, failures);
    return failures || scenes == 0 ? 1 : 0;
}
