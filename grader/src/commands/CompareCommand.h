#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader compare SUBMISSION REFERENCE`: scores any two pictures as frames are scored.
void addCompareCommand(CLI::App& app, int& exitCode);

}  // namespace grader
