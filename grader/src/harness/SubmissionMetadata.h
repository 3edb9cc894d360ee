#pragma once

#include <string>
#include <vector>

namespace grader {

/// What Gradescope's submission_metadata.json has to tell the student: how late the submission is,
/// and, where `tellPoints`, how the points changed since the last one. Sentences; none about what
/// is missing from the text or is not as it was expected: a wrong word of the platform's must not
/// cost a mark.
std::vector<std::string> remarksFrom(const std::string& metadata, double points, bool tellPoints);

}  // namespace grader
