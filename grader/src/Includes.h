#pragma once

#include <string>

namespace grader {

/// Whether every file that this text can bring in is a header, as far as can be told without a
/// preprocessor: no other name is included, and none is made up or hidden.
bool includesOnlyHeaders(const std::string& text);

}  // namespace grader
