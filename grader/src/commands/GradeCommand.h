#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// Exit codes of the grader, for every command.
inline constexpr int kFullMarks = 0;
inline constexpr int kSomethingLost = 1;
inline constexpr int kGraderFailed = 2;

/// `grader grade [ASSIGNMENT…]`: adds the command to `app`; `exitCode` is set when it has run.
void addGradeCommand(CLI::App& app, int& exitCode);

}  // namespace grader
