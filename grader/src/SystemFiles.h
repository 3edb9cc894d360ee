#pragma once

#include <string>
#include <vector>

#include "Files.h"

namespace grader {

/// Files and folders of the operating system, as a confined compiler may read them.
std::vector<fs::path> wholeSystem();

/// Links to such folders, /lib for instance: what they lead to has names in them, too.
std::vector<fs::path> systemLinks();

/// What of these a program needs that compiles nothing: the folders with libraries that the loader
/// knows, what OpenGL drivers read, and the system's programs with these names, where there are
/// any. No other program, no header, no data.
std::vector<fs::path> librariesAnd(const std::vector<std::string>& programs);

/// Throws Error where a secret lies among the system's files: an #include of a submission's reaches
/// all that its compiler sees.
void refuseAmongSystemFiles(const fs::path& secret);

}  // namespace grader
