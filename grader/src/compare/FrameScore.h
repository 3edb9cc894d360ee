#pragma once

#include <string>

#include "compare/Picture.h"

namespace grader {

/// How near a rendered frame is to its reference.
///
/// The error of a pixel is its largest channel difference in sRGB, the least over a 3x3
/// neighbourhood, taken in both directions and the larger kept, so that neither an edge that moved
/// by a pixel nor another driver's rounding counts. It is 0 up to 4/255 and 1 from 64/255. Alpha
/// is not looked at.
struct FrameScore {
    double score = 0;              ///< 0 … 1: the share of the points
    double outliers = 0;           ///< share of pixels with an error above 0
    double meanError = 0;          ///< 0 … 1
    double baseline = 0;           ///< mean error of the best picture that shows nothing learnt
    double skill = 0;              ///< 1 - meanError / baseline, at least 0
    int centreX = 0, centreY = 0;  ///< of the error, pixels from the top left
    bool sizeMatches = true;
};

/// Full marks when at most `tolerance` of the pixels are outliers. Otherwise the score is the
/// skill: the share of the way from the nearest baseline to the reference, below 1. Baselines are
/// a picture of one colour (black, the reference's mean, the reference's most frequent) and the
/// starter's own frame, when there is one. A frame of another size scores 0.
FrameScore scoreFrame(const Picture& frame, const Picture& reference, const Picture& starter,
                      double tolerance);

/// A sentence with the numbers behind the score and where the picture differs.
std::string explainScore(const FrameScore& score, const Picture& frame, const Picture& reference);

/// Where and how much two pictures of one size differ: black to white, by the error of each pixel.
Picture differenceOf(const Picture& frame, const Picture& reference);

}  // namespace grader
