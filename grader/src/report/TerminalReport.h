#pragma once

#include <string>
#include <vector>

#include "Result.h"
#include "report/TerminalWriter.h"

namespace grader {

/// What a student reads first: a row per task, below it the mistake that was recognised, and one
/// sentence with its hint per lost check. An assignment that was not started takes one line.
std::string terminalReport(const AssignmentResult& result, const TerminalStyle& style);

/// The sum over several assignments, in one line.
std::string terminalSummary(const std::vector<AssignmentResult>& results,
                            const TerminalStyle& style);

}  // namespace grader
