#pragma once

#include "Collect.h"

namespace grader {

/// Sentences on what compiles here and would not with another system's compiler or headers, in the
/// student's own C++ files: M_PI and its like, and the names near and far where a header is
/// included that brings Windows' macros of the same names along. They cost nothing.
std::vector<std::string> portabilityNotices(const Stage& stage);

/// Of `names`, the one that differs from `wanted` in upper and lower case only; empty when there
/// is none. On Linux those are two files, on Windows and macOS one.
std::string nameInOtherCase(const std::string& wanted, const std::vector<std::string>& names);

}  // namespace grader
