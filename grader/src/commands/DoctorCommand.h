#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader doctor [--json]`: which defences are active on this machine, how to get the others, and
/// what else would make results differ. Exit code 0: all are active, 1: some are not.
void addDoctorCommand(CLI::App& app, int& exitCode);

}  // namespace grader
