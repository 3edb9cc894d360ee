#pragma once

#include <string>

#include "compare/FrameScore.h"

namespace grader {

/// One sentence for a student on what the numbers of a frame mean.
std::string sentenceOn(const FrameScore& score, const Picture& frame, const Picture& reference);

/// The same on one feature; empty when it is all there. `pixels`: of the whole picture.
std::string sentenceOn(const FeatureScore& score, const std::string& title, double pixels);

}  // namespace grader
