#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader batch SUBMISSIONS --assignment ID --out FOLDER`: grades a folder of submissions. Exit
/// code 0 once every submission has a result, 2 otherwise.
void addBatchCommand(CLI::App& app, int& exitCode);

}  // namespace grader
