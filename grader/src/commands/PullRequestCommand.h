#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader pull-request`: grades what a pull request changes, with the grader of its base.
void addPullRequestCommand(CLI::App& app, int& exitCode);

}  // namespace grader
