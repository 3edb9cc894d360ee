#pragma once

#include "Fields.h"
#include "Result.h"

namespace grader {

/// A result from its document, as toJson() wrote it: all but the pixels of its pictures and the
/// evidence of its tests, so that its reports can be written again. Throws
/// nlohmann::json::exception for a document without one of its fields.
AssignmentResult resultFrom(const Json& document);

/// One of a result's diagnostics.
Diagnostic diagnosticFrom(const Json& json);

/// Numbers of a judge's or of a result's document, in which one that is not finite is null.
std::vector<double> numbersFrom(const Json& json);
/// A comparison of either.
Comparison comparisonFrom(const Json& json);

}  // namespace grader
