#pragma once

#include "Observe.h"
#include "References.h"
#include "Result.h"

namespace grader {

/// Scores all frames of an assignment: a check for each, with the frame's id.
/// A whole-frame fault, such as rows upside down, costs its share in the first frame that shows it
/// and nothing in the others.
std::vector<CheckResult> judgeFrames(const Manifest& manifest, Frames drawn,
                                     const FrameRules& rules);

/// The same checks before anything is known about them.
std::vector<CheckResult> frameChecks(const Manifest& manifest);

/// Wrong, and it came through an unfilled region of the check's own task or one that it needs: not
/// wrong, but not implemented. A region of another task is no excuse.
void markUnimplemented(const Manifest& manifest, CheckResult& check);

}  // namespace grader
