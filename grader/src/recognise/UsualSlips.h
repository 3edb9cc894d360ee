#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recognise/Signatures.h"

namespace grader {

/// A right answer and what came instead.
struct AnswerPair {
    const Evidence& right;
    const Evidence& got;
};

/// One sentence on the slip that turns every right answer into what came: transposed, negated,
/// inverse, degrees for radians, swapped axes, not normalised, off by one, off by a factor. Nothing
/// when none does, or when the answers are too few to tell.
std::optional<std::string> usualSlip(const std::vector<AnswerPair>& pairs);

}  // namespace grader
