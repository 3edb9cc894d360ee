#pragma once

#include <string>
#include <vector>

#include "Result.h"

namespace grader {

struct TerminalStyle {
    bool colours = false;
    int width = 80;
};

/// What a student reads first: a row per task, and one sentence with its hint per lost check. An
/// assignment that was not started takes one line.
std::string terminalReport(const AssignmentResult& result, const TerminalStyle& style);

/// The sum over several assignments, in one line.
std::string terminalSummary(const std::vector<AssignmentResult>& results,
                            const TerminalStyle& style);

/// Points as people read them: at most one decimal.
std::string showPoints(double points);

}  // namespace grader
