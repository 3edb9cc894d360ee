#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader window ASSIGNMENT`: builds the window of the student's own files and opens it.
void addWindowCommand(CLI::App& app);

/// `grader debug ASSIGNMENT SUITE.TEST`: that test in one process, under gdb.
void addDebugCommand(CLI::App& app);

}  // namespace grader
