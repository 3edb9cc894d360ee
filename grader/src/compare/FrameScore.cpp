#include "compare/FrameScore.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "compare/Boundary.h"
#include "compare/PixelError.h"
#include "compare/Sentences.h"

namespace grader {

namespace {

constexpr double kNothing = 0.01;          // what drivers differ by is no way to go
constexpr double kEnough = 0.99;           // counts as everything
constexpr double kMostWhenLost = 0.99;     // what is not everything stays below it
constexpr double kSharpEnough = 0.6;       // of the reference's sharpness
constexpr double kMeasurable = 0.05;       // mean error of a feature's pixels without it
constexpr double kMostlyBackground = 0.7;  // above, there is no object to be displaced

double clamped(double share) {
    return std::clamp(share, 0.0, 1.0);
}

/// What is not everything must not read as everything, and the other way round.
double settled(double score) {
    return score >= kEnough
               ? 1.0
               : std::min(clamped((score - kNothing) / (kEnough - kNothing)), kMostWhenLost);
}

/// The frame with what is no number made as wrong as can be.
Picture withoutBroken(const Picture& frame, const Picture& reference) {
    Picture picture = frame;
    for (const std::size_t pixel : frame.broken)
        for (std::size_t c = 4 * pixel; c < 4 * pixel + 3 && c < picture.rgba.size(); ++c)
            picture.rgba[c] = reference.rgba[c] > 127 ? 0 : 255;
    return picture;
}

/// Whether a frame is a baseline but for rounding: undoing a "fault" of it would reward nothing.
bool isBaseline(const Picture& frame, const FrameTruth& truth) {
    return std::any_of(truth.baselines.begin(), truth.baselines.end(), [&](const Picture& each) {
        return outlierShare(frame, each) <= kStrayPixels;
    });
}

/// A picture with all that is computed from it alone.
struct Looked {
    explicit Looked(const Picture& picture)
        : scales(scalesOf(planesOf(picture))), boundaries(boundariesOf(scales.planes[0])) {}
    const Planes& planes() const { return scales.planes[0]; }
    Scales scales;
    Boundaries boundaries;
};

/// Mean errors at each scale.
std::array<double, 3> errorsAtScales(const Map& tolerant, const Looked& frame,
                                     const Looked& reference) {
    std::array<double, 3> errors{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Map difference =
            k == 0 ? tolerant : plainDifference(frame.scales.planes[k], reference.scales.planes[k]);
        errors[k] = sumErrors(difference, frame.scales.planes[k].width).error /
                    static_cast<double>(difference.size());
    }
    return errors;
}

}  // namespace

/// A truth, and what is computed from it once.
class FrameRule::Prepared {
public:
    explicit Prepared(FrameTruth given)
        : truth(std::move(given)), planes(planesOf(truth.reference)) {}

    FrameScore score(const Picture& frame);
    Map maskOf(std::size_t feature);

    const FrameTruth truth;
    const Planes planes;

private:
    /// A feature's pixels, and what pictures that lack it make of them.
    struct FeatureData {
        Map mask, object;  ///< object: those of the mask that show no background
        double pixels = 0;
        double without = 0;  ///< error there of the best picture that lacks it
        double nothing = 0;  ///< score of the best baseline
    };
    struct WholeScore {
        double skill = 0, boundary = 0;
        double score() const { return skill * (1 + boundary) / 2; }
    };

    void prepare();
    Map objectMask(const Map* within) const;
    WholeScore wholeOf(const Map& tolerant, const Looked& frame) const;
    double rawFeature(const FeatureData& data, const Map& tolerant, const Looked& frame,
                      std::optional<Displacement>* displacement) const;
    void scoreWhole(FrameScore& result, const Map& tolerant, const Looked& frame) const;
    void scoreFeatures(FrameScore& result, const Map& tolerant, const Looked& frame) const;
    /// Where the reference has soft steps only, no frame is less sharp.
    double sharpnessShare(const Looked& frame) const {
        const double enough = kSharpEnough * reference_->boundaries.sharpness;
        return enough > 0 ? clamped(frame.boundaries.sharpness / enough) : 1.0;
    }

    std::once_flag once_;
    std::optional<Looked> reference_;
    Rgb background_{};
    Map foreground_;  ///< empty where nearly everything is foreground
    std::array<double, 3> baselineErrors_{1, 1, 1};
    double baselineBoundary_ = 0;
    double baselineDisplaced_ = 0;
    std::vector<FeatureData> features_;
};

Map FrameRule::Prepared::objectMask(const Map* within) const {
    Map mask(planes.size());
    for (std::size_t i = 0; i < mask.size(); ++i) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(planes.channel[c][i] - background_[c]));
        mask[i] = most > kDeadZone && (!within || (*within)[i]) ? 1 : 0;
    }
    return mask;
}

Map FrameRule::Prepared::maskOf(std::size_t feature) {
    Map mask = tolerantDifference(planesOf(truth.features.at(feature).ablated), planes);
    for (std::uint8_t& each : mask)
        each = each > kDeadZone ? 1 : 0;
    return mask;
}

void FrameRule::Prepared::prepare() {
    reference_.emplace(truth.reference);
    background_ = mostFrequentColour(truth.reference);
    foreground_ = objectMask(nullptr);
    const auto shown = std::count(foreground_.begin(), foreground_.end(), 1);
    if (static_cast<double>(shown) > kMostlyBackground * static_cast<double>(foreground_.size()))
        foreground_.clear();
    std::vector<Picture> nothings;
    for (const Rgb& colour : {Rgb{0, 0, 0}, meanColour(truth.reference), background_})
        nothings.push_back(flatPicture(truth.reference, colour));
    for (const Picture& each : truth.baselines)
        if (each.sameSizeAs(truth.reference))
            nothings.push_back(each);
    for (std::size_t k = 0; k < truth.features.size(); ++k) {
        FeatureData data;
        data.mask = maskOf(k);
        data.object = objectMask(&data.mask);
        data.pixels = static_cast<double>(std::count(data.mask.begin(), data.mask.end(), 1));
        data.without =
            sumErrors(tolerantDifference(planesOf(truth.features[k].ablated), planes), data.mask);
        features_.push_back(std::move(data));
    }
    std::vector<std::pair<Map, Looked>> looked;
    for (const Picture& each : nothings) {
        Looked baseline(each);
        Map tolerant = tolerantDifference(baseline.planes(), planes);
        const auto errors = errorsAtScales(tolerant, baseline, *reference_);
        for (std::size_t k = 0; k < 3; ++k)
            baselineErrors_[k] = std::min(baselineErrors_[k], errors[k]);
        baselineBoundary_ =
            std::max(baselineBoundary_, boundaryMatch(baseline.boundaries, reference_->boundaries));
        for (FeatureData& data : features_)
            data.without = std::min(data.without, sumErrors(tolerant, data.mask));
        looked.emplace_back(std::move(tolerant), std::move(baseline));
    }
    for (std::size_t k = 0; k < features_.size(); ++k) {
        const Looked ablated(truth.features[k].ablated);
        features_[k].nothing = rawFeature(
            features_[k], tolerantDifference(ablated.planes(), planes), ablated, nullptr);
    }
    // With the least errors known: what a displaced baseline would be credited with.
    for (const auto& [tolerant, baseline] : looked) {
        for (FeatureData& data : features_)
            data.nothing = std::max(data.nothing, rawFeature(data, tolerant, baseline, nullptr));
        if (!foreground_.empty())
            if (const auto moved =
                    findDisplacement(baseline.scales, reference_->scales, foreground_))
                baselineDisplaced_ = std::max(baselineDisplaced_, moved->credit(planes.width));
    }
}

FrameRule::Prepared::WholeScore FrameRule::Prepared::wholeOf(const Map& tolerant,
                                                             const Looked& frame) const {
    WholeScore whole;
    const auto errors = errorsAtScales(tolerant, frame, *reference_);
    for (std::size_t k = 0; k < 3; ++k)
        if (baselineErrors_[k] > 0)
            whole.skill += clamped(1 - errors[k] / baselineErrors_[k]) / 3;
    if (baselineBoundary_ < 1)
        whole.boundary =
            clamped((boundaryMatch(frame.boundaries, reference_->boundaries) - baselineBoundary_) /
                    (1 - baselineBoundary_));
    return whole;
}

void FrameRule::Prepared::scoreWhole(FrameScore& result, const Map& tolerant,
                                     const Looked& frame) const {
    const WholeScore whole = wholeOf(tolerant, frame);
    result.skill = whole.skill;
    result.boundary = whole.boundary;
    result.score = whole.score() * sharpnessShare(frame);
    if (foreground_.empty() || baselineDisplaced_ >= 1)
        return;
    const auto moved = findDisplacement(frame.scales, reference_->scales, foreground_);
    if (!moved)
        return;
    const double credit =
        sharpnessShare(frame) *
        clamped((moved->credit(planes.width) - baselineDisplaced_) / (1 - baselineDisplaced_));
    if (credit > result.score) {
        result.score = credit;
        result.displacement = moved;
    }
}

double FrameRule::Prepared::rawFeature(const FeatureData& data, const Map& tolerant,
                                       const Looked& frame,
                                       std::optional<Displacement>* displacement) const {
    if (data.without <= kMeasurable * data.pixels)
        return 1;  // a picture without it has it: not measurable
    const double here = clamped(1 - sumErrors(tolerant, data.mask) / data.without);
    const auto moved = findDisplacement(frame.scales, reference_->scales, data.object);
    const double there = moved ? moved->credit(planes.width) : 0;
    if (displacement && there > here)
        *displacement = moved;
    return std::max(here, there);
}

void FrameRule::Prepared::scoreFeatures(FrameScore& result, const Map& tolerant,
                                        const Looked& frame) const {
    for (std::size_t k = 0; k < features_.size(); ++k) {
        const FeatureData& data = features_[k];
        FeatureScore& score = result.features[k];
        score.pixels = data.pixels;
        score.measurable = data.nothing < kEnough;
        if (score.measurable)
            score.score = settled(
                sharpnessShare(frame) *
                clamped((rawFeature(data, tolerant, frame, &score.displacement) - data.nothing) /
                        (1 - data.nothing)));
        score.sentence =
            sentenceOn(score, truth.features[k].title, static_cast<double>(planes.size()));
    }
}

FrameScore FrameRule::Prepared::score(const Picture& given) {
    FrameScore result;
    for (const FeatureTruth& feature : truth.features)
        result.features.push_back({feature.id, 0, true, 0, {}, ""});
    result.sizeMatches = given.sameSizeAs(truth.reference) && !given.empty();
    if (!result.sizeMatches) {
        result.meanError = result.outliers = 1;
        result.sentence = sentenceOn(result, given, truth.reference);
        return result;
    }
    const Picture frame = withoutBroken(given, truth.reference);
    const Map tolerant = tolerantDifference(planesOf(frame), planes);
    const ErrorSum sum = sumErrors(tolerant, frame.width);
    const auto pixels = static_cast<double>(planes.size());
    const auto isRight = [&] { return sum.outliers / pixels <= truth.tolerance; };
    if (!isRight()) {
        result.fault = findWholeFrameFault(frame, truth.reference, sum.outliers / pixels);
        if (result.fault && isBaseline(frame, truth))
            result.fault.reset();
    }
    result.outliers = sum.outliers / pixels;
    result.meanError = sum.error / pixels;
    if (sum.error > 0) {
        result.centreX = static_cast<int>(sum.x / sum.error);
        result.centreY = static_cast<int>(sum.y / sum.error);
    }
    if (isRight() || result.fault) {
        result.score = result.skill = result.boundary = 1;
        for (FeatureScore& feature : result.features)
            feature.score = 1;
    } else {
        std::call_once(once_, [this] { prepare(); });
        const Looked looked(frame);
        scoreWhole(result, tolerant, looked);
        result.score = settled(result.score);
        scoreFeatures(result, tolerant, looked);
    }
    result.sentence = sentenceOn(result, frame, truth.reference);
    return result;
}

FrameRule::FrameRule(FrameTruth truth) : prepared_(std::make_unique<Prepared>(std::move(truth))) {}
FrameRule::~FrameRule() = default;
FrameRule::FrameRule(FrameRule&&) noexcept = default;

FrameScore FrameRule::score(const Picture& frame) const {
    return prepared_->score(frame);
}

const FrameTruth& FrameRule::truth() const {
    return prepared_->truth;
}

Picture FrameRule::maskOf(std::size_t feature) const {
    const Map mask = prepared_->maskOf(feature);
    Picture picture = flatPicture(truth().reference, {0, 0, 0});
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i])
            std::fill_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, 255);
    return picture;
}

double outlierShare(const Picture& a, const Picture& b) {
    if (!a.sameSizeAs(b) || a.empty())
        return 1;
    const Map difference = tolerantDifference(planesOf(a), planesOf(b));
    return sumErrors(difference, a.width).outliers / static_cast<double>(difference.size());
}

Picture differenceOf(const Picture& frame, const Picture& reference) {
    if (!frame.sameSizeAs(reference))
        return flatPicture(reference, {255, 255, 255});
    Picture picture = flatPicture(reference, {0, 0, 0});
    if (frame.rgba == reference.rgba && frame.broken.empty())
        return picture;
    const Map difference =
        tolerantDifference(planesOf(withoutBroken(frame, reference)), planesOf(reference));
    for (std::size_t i = 0; i < difference.size(); ++i)
        std::fill_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                    static_cast<std::uint8_t>(std::lround(255 * errorOf(difference[i]))));
    return picture;
}

}  // namespace grader
