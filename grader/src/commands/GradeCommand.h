#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader grade [ASSIGNMENT…]`: adds the command to `app`; `exitCode` is set when it has run.
void addGradeCommand(CLI::App& app, int& exitCode);

}  // namespace grader
