#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/Displacement.h"
#include "compare/Picture.h"
#include "compare/WholeFrameFault.h"

namespace grader {

/// A feature of a frame, known by the picture that lacks it.
struct FeatureTruth {
    std::string id;
    std::string title;  ///< "the highlights", for sentences
    Picture ablated;    ///< the reference as it looks without the feature
};

/// What a frame is compared with. All pictures have the reference's size.
struct FrameTruth {
    Picture reference;
    /// Pictures that show nothing learnt, such as the starter's. Black, the mean and the most
    /// frequent colour of the reference are such in any case.
    std::vector<Picture> baselines;
    std::vector<FeatureTruth> features;
    double tolerance = 0.0005;  ///< share of pixels that may differ
};

struct FeatureScore {
    std::string id;
    double score = 0;        ///< 0 … 1: the share of the feature's points
    bool measurable = true;  ///< false: a picture that shows nothing learnt has it, too
    double pixels = 0;       ///< where the feature shows
    std::optional<Displacement> displacement;
    std::string sentence;
};

/// How near a frame is to its reference; docs/scoring.md explains the rule.
struct FrameScore {
    double score = 0;      ///< 0 … 1, once a whole-frame fault is undone, before its charge
    double outliers = 0;   ///< share of the pixels with an error above 0
    double meanError = 0;  ///< 0 … 1
    double skill = 0;      ///< way from the nearest baseline to the reference, 0 … 1
    double boundary = 0;   ///< the same for the boundaries of what is shown
    int centreX = 0, centreY = 0;  ///< of the error, pixels from the top left
    bool sizeMatches = true;
    std::optional<WholeFrameFault> fault;
    std::optional<Displacement> displacement;  ///< of everything that is shown
    std::vector<FeatureScore> features;        ///< in the truth's order
    std::string sentence;                      ///< what the numbers mean, for a student
};

/// Scores frames against one truth. What depends on the truth alone is computed once, when it is
/// first needed: a right frame needs none of it. May be used by several threads.
class FrameRule {
public:
    explicit FrameRule(FrameTruth truth);
    ~FrameRule();
    FrameRule(FrameRule&&) noexcept;

    FrameScore score(const Picture& frame) const;

    const FrameTruth& truth() const;

    /// White where a feature shows, black elsewhere.
    Picture maskOf(std::size_t feature) const;

private:
    class Prepared;
    std::unique_ptr<Prepared> prepared_;
};

/// Share of the pixels of two pictures that differ by more than drivers do; 1 for two sizes.
double outlierShare(const Picture& a, const Picture& b);

/// Where and how much two pictures of one size differ: black to white, by the error of each pixel.
Picture differenceOf(const Picture& frame, const Picture& reference);

}  // namespace grader
