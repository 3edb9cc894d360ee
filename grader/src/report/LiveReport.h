#pragma once

#include "Result.h"

namespace grader {

/// Writes report and pictures of one assignment to `folder`, as a page that follows: it looks at
/// the file version.svg beside it, twice a second, and loads itself anew when that is another one.
/// A picture, because a page from a file may look at one, and one cannot do any harm: its size is
/// the version. Returns the page.
fs::path writeLiveReport(std::vector<AssignmentResult>& results, const fs::path& folder);

/// Once nobody writes it any more: the page looks seldom.
void endLiveReport(const fs::path& folder);

}  // namespace grader
