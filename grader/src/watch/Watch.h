#pragma once

#include "Collect.h"
#include "Observe.h"
#include "Sandbox.h"
#include "report/TerminalWriter.h"

namespace grader {

struct WatchOptions {
    std::vector<std::string> assignments;  ///< at least one; graded first in this order
    Submission submission;
    Renderer renderer;
    TerminalStyle style;
    fs::path report;         ///< folder of the page
    bool writePage = false;  ///< from the beginning; otherwise from the key that opens it on
    bool openPage = false;   ///< in the browser, once it is there
};

/// Grades the assignments, and again whenever one of a student's files is saved, until `q` or
/// Ctrl-C. Writes what changed to standard output. Returns the exit code that the last verdicts
/// deserve.
int watch(const Toolchain& tools, const Sandbox& sandbox, const WatchOptions& options);

}  // namespace grader
