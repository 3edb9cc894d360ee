#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader package-students OUT`: the course as students get it.
void addPackageStudentsCommand(CLI::App& app, int& exitCode);

}  // namespace grader
