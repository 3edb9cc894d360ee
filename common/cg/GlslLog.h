#pragma once

#include <string>

namespace cg {

/// Rewrites the places in a GLSL compiler's log to "file:line: message", one per line, so that an
/// editor can jump to them. Understands Mesa ("0:12(5): error: ..."), NVIDIA ("0(12) : error ...")
/// and AMD, Intel and macOS ("ERROR: 0:12: ..."); lines without a place stay as they are. Blank
/// lines and the NUL that some drivers append are dropped.
std::string nameGlslLog(const std::string& log, const std::string& file);

/// What to do about the first error of a log (as the driver wrote it), when it is one of those that
/// one driver forgives and another does not: `0f`, `unsigned int`, a float given to an int, text
/// before #version. Empty for any other.
std::string glslHint(const std::string& log, const std::string& source);

}  // namespace cg
