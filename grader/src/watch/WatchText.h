#pragma once

#include <string>
#include <vector>

#include "Fields.h"
#include "report/TerminalWriter.h"
#include "watch/Changes.h"

namespace grader {

/// What `./grade --watch` says about result documents. Whole lines, each ended.

/// A verdict after a save: the score, what was earned and lost, and the check to look at next. Of
/// what does not compile the first error, and where the assignment stood before.
std::string verdictText(const Json& result, const std::vector<Change>& changes,
                        const Baseline& baseline, const TerminalStyle& style);

/// The hint of the first check that lost something.
std::string hintText(const Json& result, const TerminalStyle& style);

/// A task that is not done: title, points, where it is in handout and code. `place`: FILE:LINE of
/// its region; may be empty.
std::string taskText(const Json& result, const Json& task, const std::string& place,
                     const TerminalStyle& style);

}  // namespace grader
