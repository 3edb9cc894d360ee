#pragma once

#include <string>

#include "Result.h"

namespace grader {

/// One check as HTML. `folder` is where writeReportPictures put the pictures.

/// A lost check: what was asked, what came out, the hint. A frame has its pictures, for report.js
/// to make a viewer of. `open`: whether it lies open before anybody clicks. `withHint`: false where
/// the same hint stands above.
std::string lostCheck(const CheckResult& check, const fs::path& folder, bool open, bool withHint);

/// A frame with full marks: small and closed, with the same tools.
std::string fullFrame(const CheckResult& check, const fs::path& folder);

/// Expected and got as matrices, with the entries marked that differ by more than the tolerance.
std::string comparisonOf(const Comparison& comparison);

}  // namespace grader
