#pragma once

#include <map>
#include <string>

#include "Result.h"

namespace grader {

/// Counts a result anew by the points of a manifest, from the share of each check that was earned,
/// and takes over its titles and hints. Nothing is graded: the manifest must differ from that of
/// the result in those alone (Key::deciding). `hintsThen`: of the tasks, when it was graded; a
/// check that has a hint of its own keeps it.
void remark(AssignmentResult& result, const Manifest& manifest,
            const std::map<std::string, std::string>& hintsThen);

/// The hints of all tasks.
std::map<std::string, std::string> hintsOf(const Manifest& manifest);

}  // namespace grader
