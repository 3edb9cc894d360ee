#pragma once

#include <string>

namespace cg {

/// Rewrites the places in a GLSL compiler's log to "file:line: message", one per line, so that an
/// editor can jump to them. Understands Mesa ("0:12(5): error: ..."), NVIDIA ("0(12) : error ...")
/// and AMD, Intel and macOS ("ERROR: 0:12: ..."); lines without a place stay as they are. Blank
/// lines and the NUL that some drivers append are dropped.
std::string nameGlslLog(const std::string& log, const std::string& file);

}  // namespace cg
