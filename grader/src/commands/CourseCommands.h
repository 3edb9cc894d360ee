#pragma once

#include <CLI/CLI.hpp>

namespace grader {

/// `grader update-references [ASSIGNMENT…]`: draws reference_images/ from solutions and starters.
void addUpdateReferencesCommand(CLI::App& app, int& exitCode);

/// `grader check-course [ASSIGNMENT…]`: proves starters, solutions and mistakes consistent.
void addCheckCourseCommand(CLI::App& app, int& exitCode);

/// `grader new-assignment NN-name`: makes a small assignment that is whole, to be replaced step by
/// step.
void addNewAssignmentCommand(CLI::App& app, int& exitCode);

/// `grader sync-starters [ASSIGNMENT…]`: carries text outside the TODO regions to the starters.
void addSyncStartersCommand(CLI::App& app, int& exitCode);

/// `grader check-recognition [ASSIGNMENT…]`: second versions of all mistakes are recognised, and
/// two at once are not mistaken for others.
void addCheckRecognitionCommand(CLI::App& app, int& exitCode);

}  // namespace grader
