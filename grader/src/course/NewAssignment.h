#pragma once

#include <string>

#include "Files.h"

namespace grader {

/// Throws Error in a student's copy, where there is no solutions/.
void requireSolutions(const fs::path& root);

/// Makes assignments/ID and solutions/ID below `root`: a small assignment that is whole (starter,
/// solution, window, frames, tests, mistakes, variants), to be replaced step by step. They are
/// copies of grader/templates/assignment, an assignment itself, in which names and numbers are
/// exchanged: 00-skeleton, its task "skeleton", its test suite, its title, its chapter. The task is
/// called as the assignment is. Both folders appear whole or not at all.
///
/// Throws Error when `id` is not of the form NN-name, when its number, its name or anything in its
/// place is there already, when there is no solutions/, and when a folder cannot be written.
void makeAssignment(const fs::path& root, const std::string& id);

}  // namespace grader
