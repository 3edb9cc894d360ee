#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// "grader replay": repeats one mark from its record.
void addReplayCommand(CLI::App& app, int& exitCode);

/// "grader merge": puts together what several batches found.
void addMergeCommand(CLI::App& app, int& exitCode);

/// "grader gallery": the pictures of a class without names.
void addGalleryCommand(CLI::App& app, int& exitCode);

}  // namespace grader
