#pragma once

#include <string>

#include "Files.h"

namespace grader {

/// What tells a program from every other: the build id that the linker made from all that is in
/// it; where it has none, a hash of the file. Reads only the head of a program with an id. Throws
/// Error when the file cannot be read.
std::string identityOf(const fs::path& program);

}  // namespace grader
