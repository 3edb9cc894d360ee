#pragma once

#include <string>
#include <vector>

#include "Result.h"

namespace grader {

struct TerminalStyle {
    bool colours = false;
    int width = 80;
    bool pictures = false;  ///< below each lost frame, in 24-bit colour
};

/// What a student reads first: a row per task, below it the mistake that was recognised, and one
/// sentence with its hint per lost check. An assignment that was not started takes one line.
std::string terminalReport(const AssignmentResult& result, const TerminalStyle& style);

/// The sum over several assignments, in one line.
std::string terminalSummary(const std::vector<AssignmentResult>& results,
                            const TerminalStyle& style);

}  // namespace grader
