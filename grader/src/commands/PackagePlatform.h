#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader package-gradescope`, `package-prairielearn`, `package-autolab`: one assignment, packed
/// for a learning platform.
void addPackagePlatformCommands(CLI::App& app, int& exitCode);

}  // namespace grader
