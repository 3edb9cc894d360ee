#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// "grader export": what a batch found, for a learning platform.
void addExportCommand(CLI::App& app, int& exitCode);

}  // namespace grader
