#pragma once

namespace grader {

/// Exit codes of the grader, for every command.
inline constexpr int kFullMarks = 0;
inline constexpr int kSomethingLost = 1;
inline constexpr int kGraderFailed = 2;

}  // namespace grader
