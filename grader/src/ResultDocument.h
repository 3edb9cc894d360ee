#pragma once

#include "Fields.h"
#include "Result.h"

namespace grader {

/// A result from its document, as toJson() wrote it: all but the pixels of its pictures and the
/// evidence of its tests, so that its reports can be written again. Throws
/// nlohmann::json::exception for a document without one of its fields.
AssignmentResult resultFrom(const Json& document);

}  // namespace grader
