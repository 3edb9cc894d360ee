#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader carry FROM TO`: brings a student's finished files to the next assignment.
void addCarryCommand(CLI::App& app, int& exitCode);

}  // namespace grader
